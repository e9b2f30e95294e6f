package org.urbi.kernel.message;

import java.net.InetSocketAddress;
import org.jspecify.annotations.Nullable;
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
  /** The receiver of what concerns the whole kernel. */
  int KERNEL = 0;

  /** The receiver of what the Java program around the kernel asks for. */
  int EMBEDDING = 1;

  /** The receiver of what UObjects in the process of the kernel ask for. */
  int COMPONENTS = 2;

  /** The receiver of what concerns jobs. */
  int JOBS = 3;

  /** The first number of the receivers that come and go. */
  int FIRST_FREE = 16;

  /** The number of its receiver. */
  int to();

  // ------------------------------------------------------------------ the kernel

  /** The kernel is to end, with that exit status. */
  record Shutdown(int status) implements Message {
    @Override
    public int to() {
      return KERNEL;
    }
  }

  /** A job that waited inside Java code can go on. */
  record Resumed(long job) implements Message {
    @Override
    public int to() {
      return JOBS;
    }
  }

  // ------------------------------------------------------------------ consoles

  /**
   * A client has connected.
   *
   * @param connection the number of the connection from now on
   * @param holdsTime whether a simulated time waits for its input
   * @param address the Internet address of the client; empty when it has none
   * @param role the name of what its lobby may do
   * @param budget what its lobby may have, in the form of options
   */
  record ConnectionOpened(
      int connection, boolean holdsTime, String address, String role, String budget)
      implements Message {
    @Override
    public int to() {
      return KERNEL;
    }
  }

  /** A client has shown who it is: its lobby may do what the role of that name may. */
  record RoleGranted(int to, String role) implements Message {}

  /** A client has sent bytes, one in each character. */
  record ConsoleBytes(int to, String bytes) implements Message {}

  /** A client will send no more. */
  record InputEnded(int to) implements Message {}

  /** A client wants the statement that is executed to end. */
  record Interrupted(int to) implements Message {}

  /** All that a lobby does is to end, for that reason. */
  record Evicted(int to, String reason) implements Message {}

  /** A client has gone. */
  record ConnectionClosed(int to) implements Message {}

  /** What carries the text of a client has failed, by a fault of our own. */
  record ConnectionFailed(int to, String error) implements Message {}

  /** A client wants to know how a text can go on. */
  record CompletionRequested(int to, int question, String text) implements Message {}

  // ------------------------------------------------------------------ remote processes

  /**
   * A process that brings UObjects has connected.
   *
   * @param peer the number of the connection from now on
   * @param name for people
   */
  record RemoteOpened(int peer, String name) implements Message {
    @Override
    public int to() {
      return KERNEL;
    }
  }

  /** A process has sent a frame (docs/protocol.md), here without its length. */
  record RemoteFrame(int to, byte[] frame) implements Message {}

  /** So much waits to be sent to a process that values of variables had better wait. */
  record RemoteCongested(int to) implements Message {}

  /** What waited to be sent to a process has left. */
  record RemoteDrained(int to) implements Message {}

  /** The connection to a process is lost. */
  record RemoteLost(int to, String reason) implements Message {}

  /** The kernel thread may read what a process sends, while it has nothing else to do. */
  record RemoteReadable(int to) implements Message {}

  /** Is the kernel thread there to read what a process sends? */
  record PollingRequested(int to) implements Message {}

  // ------------------------------------------------------------------ the rest of the machine

  /** What a job waits for is there. */
  record Answer(int to, Outcome outcome) implements Message {}

  /** A pipe or a connection has bytes to be read. */
  record BytesArrived(int to, byte[] bytes) implements Message {}

  /**
   * A pipe or a connection has nothing more to be read.
   *
   * @param error what went wrong, or null
   */
  record BytesEnded(int to, @Nullable String error) implements Message {}

  /** So many bytes have been written. */
  record BytesWritten(int to, int count) implements Message {}

  /** Bytes cannot be written any more. */
  record WritingFailed(int to, String error) implements Message {}

  /** A program has ended, with that status of the operating system. */
  record ProcessEnded(int to, int status) implements Message {}

  /** Somebody has connected to a place where the program listens. */
  record Accepted(int to, InetSocketAddress local, InetSocketAddress remote) implements Message {}

  /** Nobody can connect any more. */
  record ListeningEnded(int to) implements Message {}

  /** There is a new file in a directory that is watched. */
  record FileCreated(int to, String name) implements Message {}

  /** A file has gone from a directory that is watched. */
  record FileDeleted(int to, String name) implements Message {}

  // ------------------------------------------------------------------ UObjects in this process

  /** A UObject wants urbiscript code executed. */
  record ComponentCode(String code) implements Message {
    @Override
    public int to() {
      return COMPONENTS;
    }
  }

  /** A UObject calls a function of urbiscript, and does not wait for its end. */
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

  /** A thread of a UObject waits until what it asks for is done. */
  record ComponentRequest(int number) implements Message {
    @Override
    public int to() {
      return COMPONENTS;
    }
  }

  /** A threaded function has ended of which nobody waits for the result. */
  record ComponentDone() implements Message {
    @Override
    public int to() {
      return COMPONENTS;
    }
  }

  /** Nobody refers any more to the urbiscript object of a UObject. */
  record ComponentGone(String name) implements Message {
    @Override
    public int to() {
      return COMPONENTS;
    }
  }

  // ------------------------------------------------------------------ the program around

  /**
   * The program around the kernel asks for something.
   *
   * @param what for people
   */
  record EmbeddingCall(int number, String what) implements Message {
    @Override
    public int to() {
      return EMBEDDING;
    }
  }

  /** What the program around the kernel asked for, or listens to, is no longer wanted. */
  record EmbeddingCancel(int number) implements Message {
    @Override
    public int to() {
      return EMBEDDING;
    }
  }

  /** So many threads of the program wait for the end of the kernel. */
  record EmbeddingWaits(int threads) implements Message {
    @Override
    public int to() {
      return EMBEDDING;
    }
  }
}
