package org.urbi.kernel.lobby;

import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.World;
import org.urbi.lang.advice.Advice;
import org.urbi.lang.advice.SyntaxAdvice;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.input.Item;
import org.urbi.lang.parse.SyntaxError;
import org.urbi.lang.parse.SyntaxWarning;

/** What a lobby is told of its statements before they are executed, and of those that cannot be. */
final class StatementReports {
  /** Calls behind which nothing can be told. */
  private static final Set<String> ENDS = Set.of("quit", "reboot", "shutdown");

  private final World world;
  private final UrbiLobby lobby;
  private final Suspicions suspicions;

  StatementReports(World world, UrbiLobby lobby) {
    this.world = world;
    this.lobby = lobby;
    suspicions = new Suspicions(lobby);
  }

  /** Whether people look at the output. */
  private boolean explains() {
    return lobby.output().errors() != ErrorStyle.PLAIN;
  }

  /** A statement is about to be executed. */
  void begins(Item.Statement statement) {
    if (explains()) {
      reads(ends(statement.tree()) ? null : statement.tree().span().location().file());
      suspicions.look(statement);
    }
  }

  private static boolean ends(Ast statement) {
    return statement instanceof Ast.Message call && ENDS.contains(call.name());
  }

  /** All that has come is executed. */
  void pauses() {
    if (explains()) {
      reads(null);
    }
  }

  private void reads(@Nullable String file) {
    lobby.failures().reads(file, lobby.output());
  }

  void warning(SyntaxWarning warning) {
    if (!WarningChannel.isOff(world)) {
      Diagnostics.warning(lobby.output(), Diagnostics.place(warning.span()) + warning.message());
      Diagnostics.explain(
          lobby.output(), warning.span(), () -> Advice.of(warning.problem().hint().orElse(null)));
    }
  }

  /** People are told of the first, which may have caused the others. */
  void errors(List<SyntaxError> errors) {
    (explains() ? errors.subList(0, 1) : errors).forEach(this::error);
  }

  private void error(SyntaxError error) {
    Diagnostics.error(lobby.output(), Diagnostics.place(error.span()) + error.message());
    Diagnostics.explain(lobby.output(), error.span(), () -> SyntaxAdvice.of(error));
    if (explains()) {
      lobby.failures().add(error);
    }
  }
}
