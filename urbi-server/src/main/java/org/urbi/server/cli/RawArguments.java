package org.urbi.server.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * The command-line arguments as bytes. Java decodes arguments according to the locale, and loses
 * all non-ASCII bytes in the locale {@code C}. Where the operating system provides the bytes, they
 * are read from there.
 */
public final class RawArguments {
  private static final Path COMMAND_LINE = Path.of("/proc/self/cmdline");

  private RawArguments() {}

  /** The arguments of the program, which {@code main} was given as {@code args}. */
  public static String[] of(String[] args) {
    if ("UTF-8".equals(System.getProperty("sun.jnu.encoding"))
        || Arrays.stream(args).allMatch(RawArguments::isSafe)) {
      return args;
    }
    try {
      String[] words =
          new String(Files.readAllBytes(COMMAND_LINE), StandardCharsets.UTF_8).split("\0", -1);
      // A zero byte ends the last word, too, so splitting yields an empty word after it.
      int end = words.length - 1;
      return Arrays.copyOfRange(words, end - args.length, end);
    } catch (IOException | IllegalArgumentException | ArrayIndexOutOfBoundsException e) {
      return args;
    }
  }

  /** Whether decoding has certainly lost nothing. */
  private static boolean isSafe(String argument) {
    return argument.chars().allMatch(c -> c < 0x80 && c != '?');
  }
}
