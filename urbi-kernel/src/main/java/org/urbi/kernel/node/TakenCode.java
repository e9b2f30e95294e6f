package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/**
 * Code as a value in the hands of a lobby that may not do everything. Functions of the library, and
 * those that owners define, have the permissions of their caller. Whoever calls this one, wherever
 * it has been stored and to whomever it has been handed, it has those of that lobby: who may not do
 * something cannot have others do it without their knowledge.
 */
public final class TakenCode extends Code {
  private final Code code;
  private final UrbiObject lobby;

  private TakenCode(Shape shape, Code code, UrbiObject lobby) {
    super(shape);
    this.code = code;
    this.lobby = lobby;
  }

  /**
   * A value as the running code may store it and hand it to others: the value itself, unless it is
   * code with the permissions of its caller, and the running code may not do everything.
   */
  public static UrbiObject by(Frame taker, UrbiObject value) {
    return value instanceof Code code && !taker.job.isOwner() ? taken(taker, code) : value;
  }

  private static UrbiObject taken(Frame taker, Code code) {
    UrbiObject lobby = taker.job.lobby();
    if (code instanceof Function function) {
      return function.isUnbound() ? function.boundTo(lobby) : function;
    }
    return code instanceof TakenCode ? code : new TakenCode(code.cloneShape(), code, lobby);
  }

  @Override
  public @Nullable String name() {
    return code.name();
  }

  @Override
  public boolean isLazy() {
    return code.isLazy();
  }

  @Override
  public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
    return changesLobby(caller)
        ? caller.job.identity().doFor(lobby, () -> code.call(caller, site, self, arguments))
        : code.call(caller, site, self, arguments);
  }

  /** Whether the call makes the job run for the lobby. */
  private boolean changesLobby(Frame caller) {
    return caller.job.lobby() != lobby
        && (!isLazy() || caller.job.identity().mayLendArgumentsTo(lobby));
  }

  /** It belongs to whom the code belongs to. */
  @Override
  public @Nullable UrbiObject ownerLobby() {
    return code.ownerLobby();
  }

  @Override
  public UrbiObject cloned() {
    return new TakenCode(cloneShape(), code, lobby);
  }
}
