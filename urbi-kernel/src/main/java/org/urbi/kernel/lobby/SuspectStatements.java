package org.urbi.kernel.lobby;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Hint;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.tag.UrbiTag;
import org.urbi.lang.advice.Note;
import org.urbi.lang.advice.SuspectCode;
import org.urbi.lang.ast.Ast;

/**
 * Code that would silently wait or be left out, for a tag is frozen or blocked, would not wait for
 * an event, or would take a class for an object of it or a channel for nothing, as far as a look at
 * the slots of the lobby tells: no code runs for that.
 */
final class SuspectStatements {
  private SuspectStatements() {}

  /** What there is to say about a statement that is about to be run. */
  static List<Note> in(Ast statement, UrbiLobby lobby) {
    List<Note> found = new ArrayList<>(waiting(statement, lobby));
    for (Ast.Message call : SuspectCode.emptyCalls(statement)) {
      if (call.name().equals(type(call.name(), lobby))) {
        found.add(new Note(call.span(), Hint.CLASS_CALLED.text(call.name(), call.name())));
      }
    }
    for (Ast.Message use : SuspectCode.uses(statement, "null")) {
      if ("Channel".equals(type("null", lobby))) {
        found.add(new Note(use.span(), Hint.NIL.text()));
      }
    }
    return found;
  }

  /** The name that what a slot of the lobby holds has for its class; null if it has none. */
  private static @Nullable String type(String name, UrbiLobby lobby) {
    UrbiObject value = lobby.lookup(lobby.world().symbol(name));
    return value != null
            && !(value instanceof Code)
            && value.lookup(lobby.world().symbol("type")) instanceof UrbiString type
        ? type.value()
        : null;
  }

  private static List<Note> waiting(Ast statement, UrbiLobby lobby) {
    if (statement instanceof Ast.Tagged tagged) {
      return entered(tagged.tag(), lobby);
    }
    if (statement instanceof Ast.At at) {
      return awaited(at.condition(), lobby);
    } else if (statement instanceof Ast.WaitUntil wait) {
      return awaited(wait.condition(), lobby);
    }
    return statement instanceof Ast.Message message && message.name().equals("stop")
        ? stopped(message.target(), lobby)
        : List.of();
  }

  /** {@code t: …}. */
  private static List<Note> entered(Ast tag, UrbiLobby lobby) {
    UrbiTag named = named(tag, lobby);
    if (named == null) {
      return List.of();
    }
    String name = tag.span().text();
    if (named.state().isBlocked()) {
      return List.of(new Note(tag.span(), Hint.BLOCKED.text(name, name)));
    }
    return named.state().isFrozen()
        ? List.of(new Note(tag.span(), Hint.FROZEN.text(name, name)))
        : List.of();
  }

  /** {@code t.stop}. */
  private static List<Note> stopped(@Nullable Ast tag, UrbiLobby lobby) {
    UrbiTag named = tag == null ? null : named(tag, lobby);
    return tag != null && named != null && named.state().isFrozen()
        ? List.of(
            new Note(tag.span(), Hint.STILL_FROZEN.text(tag.span().text(), tag.span().text())))
        : List.of();
  }

  /** {@code at (e) …}, of an event. */
  private static List<Note> awaited(Ast.Condition condition, UrbiLobby lobby) {
    return condition instanceof Ast.WhenTrue when
            && value(when.expression(), lobby) instanceof UrbiEvent
        ? List.of(
            new Note(
                when.expression().span(),
                Hint.EVENT_CONDITION.text(when.expression().span().text())))
        : List.of();
  }

  /** The tag that a plain name stands for, or null. */
  private static @Nullable UrbiTag named(Ast expression, UrbiLobby lobby) {
    return value(expression, lobby) instanceof UrbiTag tag ? tag : null;
  }

  /** What a plain name stands for, or null. */
  private static @Nullable UrbiObject value(Ast expression, UrbiLobby lobby) {
    return expression instanceof Ast.Message name
            && name.target() == null
            && name.arguments() == null
        ? lobby.lookup(lobby.world().symbol(name.name()))
        : null;
  }
}
