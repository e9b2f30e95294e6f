package org.urbi.server.console;

import java.io.IOException;
import org.jline.reader.Widget;
import org.jline.reader.impl.LineReaderImpl;
import org.jline.terminal.Attributes;
import org.jline.terminal.Terminal;
import org.jline.utils.InfoCmp.Capability;

/**
 * What {@code Ctrl-Z} does: the shell has the terminal, as it was, until the session is in the
 * foreground again. Where there is no shell to bring it back, the system lets it go on.
 */
final class Suspension implements Widget {
  private final Terminal terminal;
  private final Attributes outside;

  /**
   * @param terminal the one of this process, as the shell has left it
   */
  Suspension(Terminal terminal) {
    this.terminal = terminal;
    outside = terminal.getAttributes();
  }

  /** Returns whether it could be done. */
  @Override
  public boolean apply() {
    Attributes editing = terminal.getAttributes();
    terminal.puts(Capability.keypad_local);
    terminal.writer().write(LineReaderImpl.BRACKETED_PASTE_OFF);
    terminal.flush();
    terminal.setAttributes(outside);
    try {
      return stopped();
    } finally {
      terminal.setAttributes(editing);
      terminal.puts(Capability.keypad_xmit);
      terminal.writer().write(LineReaderImpl.BRACKETED_PASTE_ON);
    }
  }

  /**
   * Stops all that runs for the same command, as the key does in other programs: a shell waits for
   * everybody in a pipeline. Returns when it goes on.
   */
  private static boolean stopped() {
    try {
      return new ProcessBuilder("/bin/sh", "-c", "kill -TSTP 0").start().waitFor() == 0;
    } catch (IOException e) {
      return false;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}
