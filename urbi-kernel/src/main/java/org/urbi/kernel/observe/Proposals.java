package org.urbi.kernel.observe;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.builtin.Primitive;
import org.urbi.kernel.library.Library;
import org.urbi.kernel.lobby.Completion;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.input.TypedText;

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

  /** A name that was found, and what is known of it. */
  private record Found(String name, @Nullable Primitive primitive, String doc) {
    static Found of(String name, @Nullable UrbiObject value) {
      if (value instanceof Primitive primitive) {
        return new Found(name, primitive, "");
      }
      boolean declared = value != null && value.ownerLobby() == value.world().values().object;
      return new Found(name, null, declared ? Types.DOCS.getOrDefault(name, "") : "");
    }

    Proposal proposal() {
      return primitive == null
          ? new Proposal(name, "", doc)
          : new Proposal(name, primitive.signature(), primitive.doc());
    }
  }

  /**
   * The completions of a text, in alphabetical order; those beyond {@link Completion#MOST} are left
   * out. No urbiscript function is called to find them.
   *
   * @param text what has been typed: {@code if (robot.body.he}
   * @return each is made when it is read, by whoever reads it: to put hundreds of signatures
   *     together is not for the kernel thread
   */
  public static List<Proposal> of(UrbiObject lobby, TypedText text) {
    List<Found> all = new ArrayList<>();
    Completion.found(lobby, text)
        .forEach((name, value) -> all.add(Found.of(name, value.orElse(null))));
    return new AbstractList<>() {
      @Override
      public Proposal get(int index) {
        return all.get(index).proposal();
      }

      @Override
      public int size() {
        return all.size();
      }
    };
  }
}
