package org.urbi.kernel.job;

/** Ends a thread of the tick loop: the loop goes on in another one. */
final class LoopMoved extends ControlFlowException {
  LoopMoved() {}
}
