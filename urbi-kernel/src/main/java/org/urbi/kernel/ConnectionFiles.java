package org.urbi.kernel;

import org.urbi.kernel.message.Message;

/** The files that the client of a connection opens and saves: others do it, a recording has it. */
final class ConnectionFiles {
  private final int number;
  private final Questions<Runnable> wanted;

  /**
   * @param number of the connection
   */
  ConnectionFiles(Kernel kernel, int number) {
    this.number = number;
    this.wanted = new Questions<>(kernel.inbox(), begin -> {});
  }

  // ------------------------------------------------------------------ from any thread

  void open(String name, Runnable begin) {
    wanted.ask(begin, question -> new Message.FileOpened(number, question, name));
  }

  void save(String name, String text, String version, Runnable begin) {
    wanted.ask(begin, question -> new Message.FileSaved(number, question, name, text, version));
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** In a replay nobody does it. */
  void take(Message.OfFiles message) {
    Runnable begin = wanted.take(message.question());
    if (begin != null) {
      begin.run();
    }
  }

  /** The connection is closed. */
  void close() {
    wanted.close();
  }
}
