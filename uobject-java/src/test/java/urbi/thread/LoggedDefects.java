package urbi.thread;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;

/** What the SDK writes to the log of the process, instead of that. */
public final class LoggedDefects implements AutoCloseable {
  private final Logger logger = Logger.getLogger("UObjectJava");
  private final List<LogRecord> logged = new CopyOnWriteArrayList<>();
  private final Handler listener =
      new Handler() {
        @Override
        public void publish(LogRecord entry) {
          logged.add(entry);
        }

        @Override
        public void flush() {}

        @Override
        public void close() {}
      };

  public LoggedDefects() {
    logger.setUseParentHandlers(false);
    logger.addHandler(listener);
  }

  /** The messages, and what they have the stack of. */
  public List<String> texts() {
    return logged.stream().map(each -> each.getMessage() + " <- " + each.getThrown()).toList();
  }

  @Override
  public void close() {
    logger.removeHandler(listener);
    logger.setUseParentHandlers(true);
  }
}
