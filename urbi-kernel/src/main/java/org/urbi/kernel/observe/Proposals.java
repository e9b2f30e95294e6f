package org.urbi.kernel.observe;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.builtin.Primitive;
import org.urbi.kernel.library.Library;
import org.urbi.kernel.lobby.Completion;
import org.urbi.kernel.object.UrbiObject;

/** What somebody who types may want, with what the library declares of it. */
public final class Proposals {
  /** What the types of the library are, by their names. */
  private static final class Types {
    private static final Map<String, String> DOCS = docs();

    private static Map<String, String> docs() {
      Map<String, String> docs = new HashMap<>();
      for (BuiltinTable table : Library.declarations()) {
        if (!table.isPart()) {
          docs.put(table.type(), table.doc());
        }
      }
      return docs;
    }
  }

  private Proposals() {}

  /**
   * The completions of a text, in alphabetical order; those beyond {@link Completion#MOST} are left
   * out. No urbiscript function is called to find them.
   *
   * @param text what has been typed: {@code if (robot.body.he}
   */
  public static List<Proposal> of(UrbiObject lobby, String text) {
    return Completion.found(lobby, text).entrySet().stream()
        .map(each ->
            each.getValue()
                .map(value -> proposal(each.getKey(), value))
                .orElseGet(() -> new Proposal(each.getKey(), "", "")))
        .toList();
  }

  private static Proposal proposal(String name, UrbiObject value) {
    if (value instanceof Primitive primitive) {
      return new Proposal(name, primitive.signature(), primitive.doc());
    }
    boolean declared = value.ownerLobby() == value.world().values().object;
    return new Proposal(name, "", declared ? Types.DOCS.getOrDefault(name, "") : "");
  }
}
