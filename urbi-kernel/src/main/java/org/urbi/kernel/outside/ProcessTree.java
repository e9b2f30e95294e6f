package org.urbi.kernel.outside;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A program with those that it has begun, and those that they have begun. Whoever kills a program
 * that keeps others, such as a shell or a launcher, wants none of them to go on: the killed one can
 * no longer end them.
 */
final class ProcessTree {
  private ProcessTree() {}

  /** Kills all of it; nothing if the program has ended. */
  static void kill(ProcessHandle program) {
    if (!program.isAlive()) {
      // Its number may be that of another one by now.
      return;
    }
    // They are found by the program that has begun them, as long as it is there.
    List<ProcessHandle> begun = begunBy(program);
    program.destroyForcibly();
    begun.forEach(ProcessTree::kill);
  }

  private static List<ProcessHandle> begunBy(ProcessHandle program) {
    try {
      return told(program);
    } catch (IOException | DirectoryIteratorException untold) {
      // It is no Linux, or a thread or the program has ended meanwhile.
      try {
        return program.children().toList();
      } catch (RuntimeException unable) {
        // There is no descriptor left to look for them.
        return List.of();
      }
    }
  }

  /** Linux tells by a file of each thread; to look at all processes takes some milliseconds. */
  private static List<ProcessHandle> told(ProcessHandle program) throws IOException {
    List<ProcessHandle> begun = new ArrayList<>();
    Path threads = Path.of("/proc", Long.toString(program.pid()), "task");
    try (DirectoryStream<Path> each = Files.newDirectoryStream(threads)) {
      for (Path thread : each) {
        for (String number : Files.readString(thread.resolve("children")).split(" ")) {
          if (!number.isBlank()) {
            ProcessHandle.of(Long.parseLong(number)).ifPresent(begun::add);
          }
        }
      }
    }
    return begun;
  }
}
