package urbi.thread;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.logging.LogRecord;
import java.util.logging.Logger;

/** What the SDK writes to the log of the process, instead of that. */
public final class LoggedDefects implements AutoCloseable {
  private final Logger logger = Logger.getLogger("UObjectJava");
  private final List<LogRecord> logged = new CopyOnWriteArrayList<>();

  public LoggedDefects() {
    logger.setFilter(entry -> !logged.add(entry));
  }

  /** The messages, and what they have the stack of. */
  public List<String> texts() {
    return logged.stream().map(each -> each.getMessage() + " <- " + each.getThrown()).toList();
  }

  @Override
  public void close() {
    logger.setFilter(null);
  }
}
