package org.urbi.server.source;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;

/**
 * The code in the options {@code --expression} and {@code --file}, in the order of the command
 * line, as one text.
 */
public final class Inputs {
  private final List<Supplier<String>> parts = new ArrayList<>();

  /** Adds the options to a program. */
  public void declare(Program program) {
    program
        .each(
            "EXP",
            "Execute the urbiscript EXP. No separator is added.",
            text -> parts.add(() -> SourceText.bytes(text)),
            "-e",
            "--expression")
        .each(
            "FILE",
            "Execute the contents of FILE (- is the standard input). No separator is added.",
            this::addFile,
            "-f",
            "--file");
  }

  /** Adds the contents of a file. */
  public void addFile(String name) {
    parts.add(() -> SourceText.file(name));
  }

  /** Adds a statement that loads a UObject module. */
  public void addModule(String name) {
    parts.add(() -> SourceText.loadModule(name));
  }

  /** Whether there is no code. */
  public boolean isEmpty() {
    return parts.isEmpty();
  }

  /**
   * The text; each character is a byte.
   *
   * @throws Failure if a file cannot be read
   */
  public String text() {
    StringBuilder text = new StringBuilder();
    for (Supplier<String> part : parts) {
      SourceText.append(text, part.get());
    }
    return text.toString();
  }
}
