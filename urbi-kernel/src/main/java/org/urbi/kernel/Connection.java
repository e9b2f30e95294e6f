package org.urbi.kernel;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.urbi.kernel.trust.Role;

/**
 * A line to a lobby of its own: text goes in and is executed, output comes back to the {@link
 * Client}. Every method may be called from any thread, and none waits.
 */
public interface Connection {
  /** Sends text, cut anywhere: every {@code char} is one byte. */
  void send(String bytes);

  /**
   * There will be no more input: the connection closes when all of its jobs are over; that of
   * {@linkplain Client#isProgram the program} when nothing can wake the kernel any more.
   */
  void end();

  /** The client has gone: all its jobs end. */
  void close();

  /** For the input that is sent from now on, the lobby may do what that role may. */
  void giveRole(Role role);

  /** Ends the statement being executed, and forgets the input behind it. */
  void interrupt();

  /**
   * Interrupts code of any lobby that never lets others run, also while the kernel is held.
   *
   * @param lobby the name of a lobby, whose foreground statement ends as by its interrupt key;
   *     empty for whatever holds the kernel right now
   * @return what was done, for people
   */
  String interrupt(String lobby);

  /**
   * What carries the text between client and lobby has failed by a fault of our own: the log keeps
   * the stack trace, the client is told of an internal error.
   *
   * @param where what has failed
   */
  void failed(String where, Throwable failure);

  /** How many bytes have been sent and not yet been taken. */
  int pendingInput();

  /** Whether what has been sent so far ends within a statement. */
  boolean incomplete();

  /**
   * The names with which that text can go on, for somebody who types it: the last name of each, in
   * alphabetical order. Nothing is called to find them.
   *
   * @return done as soon as the kernel has time, never if it ends before; without names when the
   *     lobby has closed
   */
  CompletableFuture<List<String>> complete(String text);
}
