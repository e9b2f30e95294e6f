package org.urbi.kernel.message;

import java.net.InetSocketAddress;
import org.jspecify.annotations.Nullable;
import urbi.UProperty;
import urbi.UValue;

/**
 * A message to the kernel thread. A run is determined by its messages, their order and their ticks,
 * so a message is pure data. A live object that it is about (a socket, a process, a client) stays
 * with its owner, under the number of the receiver.
 *
 * <p>The components of a message are of types that the journal can write. The number under which it
 * writes a kind of message never changes.
 */
public sealed interface Message {
  /** The receiver of messages to the whole kernel. */
  int KERNEL = 0;

  /** The receiver of requests of the embedding Java program. */
  int EMBEDDING = 1;

  /** The receiver of requests of UObjects in the kernel's process. */
  int COMPONENTS = 2;

  /** The first number for receivers that are registered at run time. */
  int FIRST_FREE = 16;

  /** The number of its receiver. */
  int to();

  /**
   * What must not be lost when memory is exhausted: a receiver that fails with an {@link
   * OutOfMemoryError} is given it again, before later messages, and does then what is left to do.
   */
  sealed interface Lasting extends Message {}

  // ------------------------------------------------------------------ the kernel

  /** The kernel must end with that exit status. */
  record Shutdown(int status) implements Message {
    @Override
    public int to() {
      return KERNEL;
    }
  }

  // ------------------------------------------------------------------ consoles

  /**
   * A client has connected.
   *
   * @param connection the number of the connection from now on
   * @param holdsTime whether simulated time stands still while input may come
   * @param address the Internet address of the client; empty when it has none
   * @param role the name of the role of its lobby
   * @param budget the limits of its lobby, as in options
   * @param errors the name of the style in which it is told of errors
   * @param program whether it is the main program
   * @param awaited whether it may send input on its own initiative
   */
  record ConnectionOpened(
      int connection,
      boolean holdsTime,
      String address,
      String role,
      String budget,
      String errors,
      boolean program,
      boolean awaited)
      implements Message {
    @Override
    public int to() {
      return KERNEL;
    }
  }

  /** A client has authenticated itself: its lobby gets the role of that name. */
  record RoleGranted(int to, String role) implements Message {}

  /** A client has sent bytes, one in each character. */
  record ConsoleBytes(int to, String bytes) implements Lasting {}

  /** A client has ended its input. */
  record InputEnded(int to) implements Lasting {}

  /** A client has ended its stream, and may be gone. */
  record HungUp(int to) implements Lasting {}

  /** A client wants to interrupt the statement being executed. */
  record Interrupted(int to) implements Message {}

  /** What frees memory. It is delivered again until it has been obeyed, before all others. */
  sealed interface Ending extends Lasting {}

  /**
   * All that a lobby does must end, for that reason.
   *
   * @param last the number of the last statement of its client that had begun when this was
   *     decided: what has come since is not to blame
   */
  record Evicted(int to, long last, String reason) implements Ending {}

  /**
   * What the embedding program has begun must end, for that reason.
   *
   * @param last the number of the job of its last request that had begun when this was decided:
   *     what it has asked for since is not to blame
   */
  record ProgramEvicted(long last, String reason) implements Ending {
    @Override
    public int to() {
      return EMBEDDING;
    }
  }

  /** A client has disconnected. */
  record ConnectionClosed(int to) implements Ending {}

  /** The code that carries a client's text has failed because of a bug of ours. */
  record ConnectionFailed(int to, String error) implements Message {}

  /** A client asks for the completions of a text. */
  record CompletionRequested(int to, int question, String text) implements Message {}

  /**
   * Somebody looks at the jobs and tags, or at variables. What is wanted is kept under the number
   * of the question.
   */
  record LookedAt(int to, int question) implements Message {}

  /** Somebody looks no longer. */
  record LookEnded(int to) implements Message {}

  /**
   * Somebody controls a job or a tag.
   *
   * @param action its name in urbiscript
   * @param tag whether it is a tag
   * @param target the number of the job or tag
   */
  record Steered(int to, int question, String action, boolean tag, long target)
      implements Message {}

  /**
   * Somebody who looks emits an event.
   *
   * @param event its number
   * @param payload expressions of urbiscript, separated by commas
   */
  record Emitted(int to, int question, long event, String payload) implements Message {}

  /**
   * Somebody who looks assigns a slot.
   *
   * @param way to the slot
   * @param value an expression of urbiscript
   */
  record Assigned(int to, int question, String way, String value) implements Message {}

  // ------------------------------------------------------------------ code

  /** What somebody wants of a text that he has written. */
  sealed interface OfCode extends Message {}

  /**
   * Somebody runs a text, under a tag of its own.
   *
   * @param run by which the connection knows it
   * @param file the name by which errors call it
   */
  record CodeRun(int to, int run, String file, String code) implements OfCode {}

  /** Somebody ends a text that runs, and all that it has begun. */
  record CodeStopped(int to, int question, int run) implements OfCode {}

  // ------------------------------------------------------------------ files

  /** What somebody does with a file of source text. Who does it is known by the question. */
  sealed interface OfFiles extends Message {
    int question();
  }

  /** Somebody opens a file. */
  record FileOpened(int to, int question, String name) implements OfFiles {}

  /**
   * Somebody saves a file.
   *
   * @param version of which the text has been made; empty if it is to be a new file
   */
  record FileSaved(int to, int question, String name, String text, String version)
      implements OfFiles {}

  // ------------------------------------------------------------------ variables

  /** What somebody who looks at variables wants. */
  sealed interface OfVariables extends Message {}

  /**
   * Somebody wants to be told of variables.
   *
   * @param all whether all are followed at once
   * @param paths of slots that are told besides, a line for each
   */
  record FeedBegun(int to, boolean all, String paths) implements OfVariables {}

  /** Somebody begins or ends to follow the variable of that number. */
  record Followed(int to, int variable, boolean on) implements OfVariables {}

  /** Somebody asks for the values of slots; their paths are kept under the question. */
  record ValuesAsked(int to, int question) implements OfVariables {}

  /**
   * Somebody gives a slot a value.
   *
   * @param value a Double, Boolean, String, a List or Map of these, or null for nil
   */
  record ValueGiven(int to, int question, String path, Data value) implements OfVariables {}

  /**
   * Somebody calls the function in a slot.
   *
   * @param arguments a List of what may be {@linkplain ValueGiven given}
   */
  record FunctionCalled(int to, int question, String path, Data arguments) implements OfVariables {}

  // ------------------------------------------------------------------ remote processes

  /**
   * A process that brings UObjects has connected.
   *
   * @param peer the number of the connection from now on
   * @param name for people
   * @param console the number of the connection whose lobby executes what it sends; -1 without one
   */
  record RemoteOpened(int peer, String name, int console) implements Message {
    @Override
    public int to() {
      return KERNEL;
    }
  }

  /** A process has sent a frame (docs/protocol.md), here without its length. */
  record RemoteFrame(int to, byte[] frame) implements Message {}

  /** So much output waits for a process that new values of variables are held back. */
  record RemoteCongested(int to) implements Message {}

  /** The output that waited for a process has been sent. */
  record RemoteDrained(int to) implements Message {}

  /** The connection to a process is lost. */
  record RemoteLost(int to, String reason) implements Message {}

  /** The kernel thread may itself read what a process sends while it is idle. */
  record RemoteReadable(int to) implements Message {}

  /** Asks whether the kernel thread is idle, so that it can itself read what a process sends. */
  record PollingRequested(int to) implements Message {}

  // ------------------------------------------------------------------ the rest of the machine

  /** The result for which a job waits. */
  record Answer(int to, Outcome outcome) implements Message {}

  /** Bytes have arrived from a pipe or a connection. */
  record BytesArrived(int to, byte[] bytes) implements Message {}

  /**
   * A pipe or a connection has reached its end.
   *
   * @param error what went wrong, or null
   */
  record BytesEnded(int to, @Nullable String error) implements Message {}

  /** That number of bytes has been written. */
  record BytesWritten(int to, int count) implements Message {}

  /** Writing has failed, and no more bytes will be written. */
  record WritingFailed(int to, String error) implements Message {}

  /** A child process has ended, with that status of the operating system. */
  record ProcessEnded(int to, int status) implements Message {}

  /** A server socket has accepted a connection. */
  record Accepted(int to, InetSocketAddress local, InetSocketAddress remote) implements Message {}

  /** A server socket was closed. */
  record ListeningEnded(int to) implements Message {}

  /** A file was created in a watched directory. */
  record FileCreated(int to, String name) implements Message {}

  /** A file was deleted from a watched directory. */
  record FileDeleted(int to, String name) implements Message {}

  // ------------------------------------------------------------------ UObjects in this process

  /** A UObject asks for urbiscript code to be executed. */
  record ComponentCode(String code) implements Message {
    @Override
    public int to() {
      return COMPONENTS;
    }
  }

  /** A UObject calls an urbiscript function without waiting for its end. */
  record ComponentCall(String object, String method, UValue[] arguments) implements Message {
    @Override
    public int to() {
      return COMPONENTS;
    }
  }

  /** A UObject emits an event from a thread of its own. */
  record ComponentEvent(String name, UValue[] payload) implements Message {
    @Override
    public int to() {
      return COMPONENTS;
    }
  }

  /** A threaded function has ended, for whose result nobody waits. */
  record ComponentDone() implements Message {
    @Override
    public int to() {
      return COMPONENTS;
    }
  }

  /** The urbiscript object of a UObject is no longer referenced. */
  record ComponentGone(String name) implements Message {
    @Override
    public int to() {
      return COMPONENTS;
    }
  }

  // ------------------------------------------------------------------ threads of UObjects

  /** What a thread of a UObject asks for; it waits for the answer to that number. */
  sealed interface OfComponent extends Message {
    int number();

    @Override
    default int to() {
      return COMPONENTS;
    }
  }

  /** What such a thread asks of a variable that it has got before, under that number. */
  sealed interface OfVariable extends OfComponent {
    int variable();
  }

  /** The thread wants the variable of that name, maybe as the input of a component. */
  record VariableWanted(int number, String name, boolean input) implements OfComponent {}

  /** The thread wants to emit the event of that name. */
  record EventWanted(int number, String name) implements OfComponent {}

  /** The thread wants the UObject, or the hub, of that name. */
  record ObjectWanted(int number, String name, boolean hub) implements OfComponent {}

  /** What can be read of a variable; see {@link urbi.USlot}. */
  enum Reading {
    VALUE,
    TIMESTAMP,
    INPUT,
    OUTPUT
  }

  /** The thread reads a variable. */
  record VariableRead(int number, int variable, Reading what) implements OfVariable {}

  /** The thread assigns a variable. */
  record VariableWritten(int number, int variable, UValue value) implements OfVariable {}

  /** The thread reads a property of a variable. */
  record PropertyRead(int number, int variable, UProperty property) implements OfVariable {}

  /** The thread assigns a property of a variable. */
  record PropertyWritten(int number, int variable, UProperty property, UValue value)
      implements OfVariable {}

  /** How a variable can be used; see {@link urbi.USlot}. */
  enum Use {
    OWNED,
    BYPASS,
    RTP
  }

  /** The thread changes how a variable is used. */
  record VariableUsed(int number, int variable, Use use, boolean on) implements OfVariable {}

  /** The thread ends all notifications of a variable. */
  record VariableUnnotified(int number, int variable) implements OfVariable {}

  /** The thread starts that class of UObjects, which a replay looks for under that name of Java. */
  record ClassStarted(int number, String name) implements OfComponent {}

  /** The thread locks the kernel; what it asks from then on goes to that receiver. */
  record KernelLocked(int number, int lock) implements OfComponent {}

  /** What a thread asks for that has locked the kernel. */
  record AskedWhileLocked(int to, Message what) implements Message {}

  /** A thread has unlocked the kernel, or has ended. */
  record KernelUnlocked(int to) implements Message {}

  /**
   * The thread asks for what only its own objects and code can say: a replay does not have them.
   */
  record ComponentRequest(int number) implements OfComponent {}

  // ------------------------------------------------------------------ the program around

  /** What the embedding program asks for; it waits for the answer to that number. */
  sealed interface OfProgram extends Message {
    int number();

    @Override
    default int to() {
      return EMBEDDING;
    }
  }

  /** What it asks of an object that it has got before, under that number; 0 is its lobby. */
  sealed interface OfObject extends OfProgram {
    int object();
  }

  /** What the embedding program wants of a result. */
  enum Form {
    /** A copy, of what has a counterpart in Java. */
    COPY,
    /** A handle on the object. */
    HANDLE,
    /** The bytes of a string. */
    BYTES
  }

  /**
   * The program evaluates source text.
   *
   * @param object that is {@code this} of the text
   * @param file the name by which errors call it, or null
   */
  record SourceEvaluated(int number, int object, String source, @Nullable String file, Form form)
      implements OfObject {}

  /**
   * The program calls a function.
   *
   * @param function the name of a method of the object; of the lobby, the way to it
   * @param arguments a List
   */
  record MethodCalled(int number, int object, String function, Data arguments)
      implements OfObject {}

  /**
   * The program calls an object, which is a function.
   *
   * @param arguments a List
   */
  record ObjectCalled(int number, int object, Data arguments) implements OfObject {}

  /** The program reads a slot. */
  record SlotRead(int number, int object, String slot) implements OfObject {}

  /** The program assigns a slot, or creates it. */
  record SlotWritten(int number, int object, String slot, Data value) implements OfObject {}

  /** The program asks whether there is a slot. */
  record SlotSought(int number, int object, String slot) implements OfObject {}

  /** The program removes a slot. */
  record SlotRemoved(int number, int object, String slot) implements OfObject {}

  /** The program asks for the names of all slots. */
  record SlotsListed(int number, int object) implements OfObject {}

  /** The program asks for an object as text. */
  record ObjectShown(int number, int object) implements OfObject {}

  /** The program asks for its lobby, or for a new object that inherits from it. */
  record ScopeWanted(int number, boolean fresh) implements OfProgram {}

  /** The program listens to the event that an expression gives, or to the changes of its value. */
  record Listened(int number, String expression, boolean changes) implements OfProgram {}

  /** The program defines a function that is written in Java, which a replay does not have. */
  record FunctionDefined(int number, String name) implements OfProgram {}

  /** The embedding program cancels a request or removes a listener. */
  record EmbeddingCancel(int number) implements Message {
    @Override
    public int to() {
      return EMBEDDING;
    }
  }

  /** The number of threads of the embedding program that wait for the end of the kernel. */
  record EmbeddingWaits(int threads) implements Message {
    @Override
    public int to() {
      return EMBEDDING;
    }
  }
}
