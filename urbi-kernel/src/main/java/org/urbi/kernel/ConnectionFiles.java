package org.urbi.kernel;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntFunction;
import org.urbi.kernel.message.Message;

/** The files that the client of a connection opens and saves: others do it, a recording has it. */
final class ConnectionFiles {
  private final Kernel kernel;
  private final int number;
  private final AtomicInteger questions = new AtomicInteger();
  private final Map<Integer, Runnable> wanted = new ConcurrentHashMap<>();
  private volatile boolean closed;

  /**
   * @param number of the connection
   */
  ConnectionFiles(Kernel kernel, int number) {
    this.kernel = kernel;
    this.number = number;
  }

  // ------------------------------------------------------------------ from any thread

  void open(String name, Runnable begin) {
    post(question -> new Message.FileOpened(number, question, name), begin);
  }

  void save(String name, String text, String version, Runnable begin) {
    post(question -> new Message.FileSaved(number, question, name, text, version), begin);
  }

  private void post(IntFunction<Message> message, Runnable begin) {
    int question = questions.incrementAndGet();
    wanted.put(question, begin);
    kernel.inbox().post(message.apply(question));
    if (closed) {
      wanted.clear();
    }
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** In a replay nobody does it. */
  void take(Message.OfFiles message) {
    Runnable begin = wanted.remove(message.question());
    if (begin != null) {
      begin.run();
    }
  }

  /** The connection is closed. */
  void close() {
    closed = true;
    wanted.clear();
  }
}
