package org.urbi.server.source;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.urbi.server.options.Failure;

/** Prepares text for a lobby: each character is a byte, and files are framed by their names. */
public final class SourceText {
  private static final String PUSH = "//#push";

  private SourceText() {}

  /** The bytes of a Java string in UTF-8, one in each character. */
  public static String bytes(String text) {
    return new String(text.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
  }

  /**
   * The contents of a file, framed so that messages name it ({@code //#push}, {@code //#pop}); the
   * {@code #!} line of a script becomes a comment. The name {@code -} stands for the standard
   * input.
   *
   * @throws Failure if it cannot be read
   */
  public static String file(String name) {
    boolean standardInput = name.equals("-");
    byte[] contents;
    try {
      contents = standardInput ? System.in.readAllBytes() : Files.readAllBytes(Path.of(name));
    } catch (NoSuchFileException e) {
      throw Failure.of("no such file: " + name);
    } catch (IOException | InvalidPathException e) {
      throw Failure.of("cannot read " + name + ": " + e.getMessage());
    }
    return framed(
        standardInput ? "stdin" : name, new String(contents, StandardCharsets.ISO_8859_1));
  }

  /** The statement that loads a UObject module, option {@code --module}. */
  public static String loadModule(String module) {
    return bytes("loadModule(\"" + escaped(module) + "\");\n");
  }

  /** The statement that loads it in a process of its own, option {@code --isolate}. */
  public static String isolateModule(String module) {
    return bytes("loadModule(\"" + escaped(module) + "\", \"isolate\");\n");
  }

  /** Appends a text to another. A frame must begin a line, so a line break is added if needed. */
  public static void append(StringBuilder text, String more) {
    if (more.startsWith(PUSH) && !text.isEmpty() && text.charAt(text.length() - 1) != '\n') {
      text.append('\n');
    }
    text.append(more);
  }

  /** A text, one byte in each character, framed by the name of what it comes from. */
  public static String framed(String name, String contents) {
    String quoted = escaped(bytes(name));
    String text = contents.startsWith("#!") ? "//" + contents.substring(2) : contents;
    return PUSH + " 1 \"" + quoted + "\"\n" + text + "\n//#pop\n";
  }

  private static String escaped(String text) {
    return text.replace("\\", "\\\\").replace("\"", "\\\"");
  }
}
