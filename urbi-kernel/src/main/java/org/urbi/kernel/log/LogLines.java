package org.urbi.kernel.log;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;

/** Takes the lines of a log, and tells those who listen of them. From any thread. */
public final class LogLines implements Consumer<String> {
  private final Consumer<String> log;
  private final List<Consumer<String>> listeners = new CopyOnWriteArrayList<>();

  /**
   * @param log where the lines go, whoever listens
   */
  public LogLines(Consumer<String> log) {
    this.log = log;
  }

  @Override
  public void accept(String line) {
    log.accept(line);
    listeners.forEach(listener -> listener.accept(line));
  }

  /** Tells somebody of each line, who must not keep the thread, until the action is run. */
  public Runnable listen(Consumer<String> listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }
}
