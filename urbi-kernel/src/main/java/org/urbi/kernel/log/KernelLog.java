package org.urbi.kernel.log;

import java.util.function.Consumer;

/**
 * The log of a kernel, for its administrator.
 *
 * @param level how much is shown
 * @param lines takes each line, without its end
 */
public record KernelLog(LogLevel level, Consumer<String> lines) {
  /** Whether what has that level is shown. */
  public boolean shows(LogLevel of) {
    return of.compareTo(level) <= 0;
  }

  public void write(String line) {
    lines.accept(line);
  }
}
