package org.urbi.bridge;

import com.sun.jna.NativeLibrary;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The threads of a module that have called the host. While one of them lives, the module must not
 * be unloaded.
 */
public final class NativeThreads {
  /** What threads of C++ are called in Java. */
  static final String NAME = "urbi-native";

  /** The threads of all modules. */
  private static final Set<Thread> ALL = ConcurrentHashMap.newKeySet();

  private final Set<Thread> own = ConcurrentHashMap.newKeySet();

  NativeThreads() {}

  /** A thread has asked for something. */
  void met(Thread thread) {
    if (!thread.isVirtual() && thread.getName().startsWith(NAME) && own.add(thread)) {
      own.removeIf(each -> !each.isAlive());
      ALL.removeIf(each -> !each.isAlive());
      ALL.add(thread);
    }
  }

  boolean anyAlive() {
    return own.stream().anyMatch(Thread::isAlive);
  }

  /**
   * Ends the process, as {@link Runtime#halt} does. Where threads of modules still run, the static
   * variables of C++ stay as they are: those threads would stumble over their destructors.
   */
  public static void halt(int status) {
    if (!ALL.isEmpty() && ALL.stream().anyMatch(Thread::isAlive)) {
      NativeLibrary.getProcess().getFunction("fflush").invokeInt(new Object[] {null});
      exit(status);
    }
    Runtime.getRuntime().halt(status);
  }

  /** Ends the process without asking the virtual machine, if that can be done. */
  public static void exit(int status) {
    try {
      NativeLibrary.getProcess().getFunction("_exit").invokeVoid(new Object[] {status});
    } finally {
      // Where memory is exhausted, or there is no such function.
      Runtime.getRuntime().halt(status);
    }
  }
}
