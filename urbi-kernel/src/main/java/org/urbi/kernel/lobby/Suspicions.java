package org.urbi.kernel.lobby;

import org.jspecify.annotations.Nullable;
import org.urbi.lang.advice.Advice;
import org.urbi.lang.advice.LocalDeclarations;
import org.urbi.lang.advice.Note;
import org.urbi.lang.advice.SuspectCode;
import org.urbi.lang.input.Item;

/** Tells people at a terminal of code that is valid, but does not do what it looks like. */
final class Suspicions {
  private final UrbiLobby lobby;
  private Item.@Nullable Statement before;

  Suspicions(UrbiLobby lobby) {
    this.lobby = lobby;
  }

  /** Tells what there is to say about a statement that is about to be run. */
  void look(Item.Statement statement) {
    SuspectCode.in(statement.tree(), statement.separator()).forEach(this::tell);
    SuspectStatements.in(statement.tree(), lobby).forEach(this::tell);
    if (before != null) {
      SuspectCode.between(before.tree(), before.separator(), statement.tree()).forEach(this::tell);
    }
    before = statement;
    lobby.failures().addLocal(LocalDeclarations.in(statement.tree()));
  }

  private void tell(Note note) {
    Diagnostics.explain(lobby.output(), note.span(), () -> Advice.of(note.text()));
  }
}
