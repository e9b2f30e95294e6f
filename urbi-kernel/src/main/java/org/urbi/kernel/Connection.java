package org.urbi.kernel;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.observe.CallEnd;
import org.urbi.kernel.observe.CodeEnd;
import org.urbi.kernel.observe.Media;
import org.urbi.kernel.observe.Places;
import org.urbi.kernel.observe.Proposal;
import org.urbi.kernel.observe.Sample;
import org.urbi.kernel.observe.Steering;
import org.urbi.kernel.observe.VariableListener;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.observe.ViewRequest;
import org.urbi.kernel.trust.Role;

/**
 * A connection to a lobby of its own: text that is sent is executed, and output comes back to the
 * {@link Client}. Every method may be called from any thread, and none waits.
 */
public interface Connection {
  /**
   * A text that is run.
   *
   * @param number by which the connection knows it
   * @param tag the name of its tag
   * @param end done when it has ended; exceptionally when the connection has closed before
   */
  record CodeRun(int number, String tag, CompletableFuture<CodeEnd> end) {}

  /** The number by which the kernel knows it. */
  int number();

  /** Sends a piece of input; it may end anywhere, and every {@code char} is one byte. */
  void send(String bytes);

  /**
   * There will be no more input. The connection closes when all of its jobs have ended; the
   * connection of {@linkplain Client#isProgram the program} closes when nothing can wake the kernel
   * any more.
   */
  void end();

  /**
   * The client has ended its stream, and may be gone. What it has sent before is executed as far as
   * it runs without waiting: once a statement in the foreground waits, or no statement is left, the
   * connection closes and all its jobs end.
   */
  void hangUp();

  /** The number of no turn, see {@link #runningTurn}. */
  long NO_TURN = -1;

  /**
   * The number of the turn, without an end so far, in which code of this client runs, or {@link
   * #NO_TURN}. As long as it is the same, that code lets nobody else run. May be asked on any
   * thread.
   */
  long runningTurn();

  /** The client has gone: all its jobs end. */
  void close();

  /** Gives the lobby a role, which applies to the input sent from now on. */
  void giveRole(Role role);

  /** Ends the statement being executed, and drops the input that waits behind it. */
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
   * Reports a bug in the code that carries text between client and lobby: the log keeps the stack
   * trace, the client is sent an internal error.
   *
   * @param where what has failed
   */
  void failed(String where, Throwable failure);

  /** How many bytes have been sent and not yet been taken. */
  int pendingInput();

  /** Whether what has been sent so far ends within a statement. */
  boolean incomplete();

  /**
   * The completions of a text that somebody is typing: for each the last name, in alphabetical
   * order. No urbiscript function is called to find them.
   *
   * @return done as soon as the kernel has time, never if it ends before; without names when the
   *     lobby has closed
   */
  CompletableFuture<List<String>> complete(String text);

  /**
   * The completions of a text that somebody is typing, as of {@link #complete}, with what the
   * library declares of them.
   *
   * @return as of {@link #look}
   */
  CompletableFuture<List<Proposal>> propose(String text);

  /**
   * Looks at the jobs and tags of the kernel, for people. The first look begins to measure the
   * jobs, until {@link #lookNoMore} or the end of the connection.
   *
   * @return done as soon as the kernel has time; exceptionally when the connection has closed
   */
  CompletableFuture<View> look(ViewRequest wanted);

  /** Nobody looks any longer. */
  void lookNoMore();

  /**
   * Has all told that has changed since the last look when the kernel ends, or the process with it:
   * then nobody could ask.
   *
   * @param wanted asked then
   * @param told is given each view, on the kernel thread, before its clients are told of the end
   */
  void lookAtEnd(Supplier<ViewRequest> wanted, Consumer<View> told);

  /**
   * Controls a job or a tag, as far as the role of the lobby allows.
   *
   * @param tag whether it is a tag
   * @param target the number of the job or tag
   * @return why it cannot be done, empty when it was; as soon as the kernel has time, exceptionally
   *     when the connection has closed
   */
  CompletableFuture<String> steer(Steering.Action action, boolean tag, long target);

  /**
   * Emits an event, in a job of the lobby.
   *
   * @param event its number
   * @param payload expressions of urbiscript, separated by commas
   * @return what went wrong, empty when it has been emitted; exceptionally when the connection has
   *     closed
   */
  CompletableFuture<String> emit(long event, String payload);

  /**
   * Assigns a slot, in a job of the lobby.
   *
   * @param way to the slot, as {@link Places} says
   * @param value an expression of urbiscript
   * @return as of {@link #emit}
   */
  CompletableFuture<String> assign(String way, String value);

  /**
   * Runs a text: as a console does, but in a job and under a tag of its own. It is parsed as a
   * whole, so that nothing runs when there is a syntax error in it.
   *
   * @param file the name by which errors call the text
   */
  CodeRun run(String file, String code);

  /**
   * Ends a text that is run, by its number, and all that it has begun.
   *
   * @return why it cannot be done, empty when it was; exceptionally when the connection has closed
   */
  CompletableFuture<String> stop(int run);

  /**
   * The client opens a file: that is told here before it is done, so that a recording has it. In a
   * replay it is not done.
   *
   * @param begin does it; on the kernel thread, which must not wait for it. Not called when the
   *     connection has closed
   */
  void open(String name, Runnable begin);

  /**
   * The client saves a file, as {@link #open}.
   *
   * @param version of which the text has been made; empty if it is to be a new file
   */
  void save(String name, String text, String version, Runnable begin);

  /**
   * Reads the values of slots, for people.
   *
   * @param ways to them, as {@link Places} says; those beyond {@link Sample#MOST} are passed over
   * @return as of {@link #look}
   */
  CompletableFuture<Sample> sample(List<String> ways);

  /**
   * Reads a Binary, for people.
   *
   * @param way to the slot, as {@link Places} says
   * @return as of {@link #look}; without a content when there is none that people can see or hear
   */
  CompletableFuture<Optional<Media>> media(String way);

  /**
   * Begins to tell a listener of variables; once for a connection. It ends with the connection.
   *
   * @param all whether the listener follows all that there are and will be
   * @param paths of slots that are told besides: {@code robot.body.x}
   */
  void feed(VariableListener listener, boolean all, List<String> paths);

  /** Begins or ends to follow a variable, by the number under which it has appeared. */
  void follow(int variable, boolean on);

  /**
   * The values of slots, as {@link VariableListener#value} has them; null also for those that are
   * not there.
   *
   * @return done as soon as the kernel has time; exceptionally when the connection has closed
   */
  CompletableFuture<List<@Nullable Object>> values(List<String> paths);

  /**
   * Assigns a slot, or emits the event that is in it, as code of the lobby would.
   *
   * @param path as the variable has appeared, or {@code robot.body.x}
   * @param value a Double, Boolean, String, a List or Map of these, or null for nil; for an event a
   *     list of the payload
   * @return why it cannot be done, empty when it was; exceptionally when the connection has closed
   */
  CompletableFuture<String> give(String path, @Nullable Object value);

  /**
   * Calls the function in a slot, in a job of the lobby.
   *
   * @param path to it, as of {@link #give}
   * @param arguments what may be given
   * @return what it has returned; exceptionally when the connection has closed
   */
  CompletableFuture<CallEnd> call(String path, List<@Nullable Object> arguments);
}
