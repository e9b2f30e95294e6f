package org.urbi.kernel.library.lobby;

import java.util.Iterator;
import java.util.stream.Stream;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.time.RateLimit;

/**
 * What code reports, on its way to the log. Each line begins with the category, so that none looks
 * like one of the server itself. Of clients the log takes only so much in a second, of each and of
 * all together: nobody hides what others tell, and what a reader of the log is sent stays readable.
 */
final class Reports {
  /**
   * How many characters all clients may write in a second: half of what a server keeps for a log
   * that is read slowly.
   */
  private static final int OF_ALL = 1 << 15;

  /** The longest text of a client that is not cut, in characters. */
  private static final int LONGEST = 1 << 12;

  private static final String CUT = "…";

  private final KernelLog log;
  private final RateLimit ofAll = new RateLimit(OF_ALL);

  Reports(KernelLog log) {
    this.log = log;
  }

  boolean shows(LogLevel level) {
    return level != LogLevel.NONE && log.shows(level);
  }

  /**
   * Writes a text, which may have several lines.
   *
   * @param job whose lobby reports it
   */
  void write(Job job, UrbiLogger logger, String category, String text) {
    if (job.lobby() instanceof UrbiLobby lobby && lobby.budget().log().isLimit()) {
      writeLimited(job.scheduler().now(), lobby, logger, cut(category), cut(text));
    } else {
      lines(text).forEach(line -> log.write(logger.line(job.lobby(), category, line)));
    }
  }

  private void writeLimited(
      long now, UrbiLobby lobby, UrbiLogger logger, String category, String text) {
    Iterator<String> lines = lines(text).iterator();
    boolean passes = true;
    while (passes && lines.hasNext()) {
      String line = logger.line(lobby, category, lines.next());
      passes = passes(now, lobby, line.length());
      if (passes) {
        log.write(line);
      }
    }
  }

  private static Stream<String> lines(String text) {
    return text.isEmpty() ? Stream.of(text) : text.lines();
  }

  private static String cut(String text) {
    return text.length() <= LONGEST ? text : text.substring(0, LONGEST) + CUT;
  }

  private boolean passes(long now, UrbiLobby lobby, int length) {
    RateLimit own = lobby.budget().log();
    if (own.take(now, length)) {
      return passesWithAll(now, length);
    }
    if (own.beginsToRefuse()) {
      String told = Problem.LOGS_TOO_MUCH.text(lobby.description());
      if (passesWithAll(now, told.length())) {
        log.write("urbi: " + told);
      }
    }
    return false;
  }

  private boolean passesWithAll(long now, int length) {
    boolean passes = ofAll.take(now, length);
    if (ofAll.beginsToRefuse()) {
      log.write("urbi: " + Problem.CLIENTS_LOG_TOO_MUCH.text());
    }
    return passes;
  }
}
