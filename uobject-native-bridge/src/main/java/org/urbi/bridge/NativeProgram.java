package org.urbi.bridge;

import java.util.Arrays;
import urbi.UModuleException;
import urbi.remote.RemoteProgram;

/**
 * A program of C++ with UObjects of its own, which has started this Java virtual machine in its
 * process ({@code urbi/umain.hh}) and is connected to a server.
 */
public final class NativeProgram {
  private NativeProgram() {}

  /**
   * Runs the UObjects of the program in whose process this is.
   *
   * @param words the name of the program, and options as those of {@link urbi.UMain}
   * @param block whether to return when the connection has ended; at once otherwise
   * @return the exit status
   */
  public static int run(String[] words, boolean block) {
    String[] options = Arrays.copyOfRange(words, 1, words.length);
    NativeModule program;
    try {
      program = NativeModule.ofProcess(words[0]);
    } catch (UModuleException e) {
      System.err.println(e.getMessage());
      return 1;
    }
    if (block) {
      return new RemoteProgram().run(options, program.module(), System.out, System.err);
    }
    Thread.ofPlatform()
        .name("urbi-main")
        .daemon()
        .start(() -> new RemoteProgram().run(options, program.module(), System.out, System.err));
    return 0;
  }
}
