package org.urbi.server.console;

import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import org.jline.reader.Candidate;
import org.jline.reader.Completer;
import org.jline.reader.LineReader;
import org.jline.reader.ParsedLine;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.log.FailureLog;

/**
 * Completes what is typed at a terminal. An answer that is there at once is the editor's, which
 * lists the names and lets people choose. Behind a busy kernel or a slow disk nobody waits: the
 * answer is shown when it comes, unless something else has been typed by then.
 */
final class Completions implements Completer {
  /** How long a key waits for its answer, in milliseconds. Nothing else is shown meanwhile. */
  private static final int PROMPT_MS = 100;

  /** How many names of a late answer are shown. */
  private static final int MOST_SHOWN = 100;

  /** The editor's name of what shows a late answer. */
  private static final String SHOW_LATE = "show-late-completions";

  /** Where it is shown: a terminal that stands still would hold who answers. */
  private static final Executor LATE = FailureLog.THREADS.virtualThreads("urbi-completions");

  private record Question(
      String text, String word, CompletableFuture<? extends Collection<String>> names) {}

  private final Function<String, CompletableFuture<? extends Collection<String>>> names;

  /** What has not been answered at once. It is touched by whoever has the editor's lock. */
  private @Nullable Question pending;

  /**
   * @param names gives the names that the word at the end of a text may become, sooner or later
   */
  Completions(Function<String, CompletableFuture<? extends Collection<String>>> names) {
    this.names = names;
  }

  /** Makes an editor able to show late answers. */
  void attach(LineReader reader) {
    reader.getWidgets().put(SHOW_LATE, () -> showLate(reader));
  }

  @Override
  public void complete(LineReader reader, ParsedLine line, List<Candidate> candidates) {
    String text = line.line().substring(0, line.cursor());
    if (isAwaited(text)) {
      return;
    }
    Question asked = new Question(text, line.word(), names.apply(text));
    pending = null;
    try {
      for (String name : asked.names().get(PROMPT_MS, TimeUnit.MILLISECONDS)) {
        candidates.add(new Candidate(name, name, null, null, null, null, false));
      }
    } catch (TimeoutException e) {
      pending = asked;
      asked.names().thenRun(() -> LATE.execute(() -> answered(reader)));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException e) {
      // There are no names.
    }
  }

  private boolean isAwaited(String text) {
    Question asked = pending;
    return asked != null && !asked.names().isDone() && asked.text().equals(text);
  }

  private static void answered(LineReader reader) {
    try {
      reader.callWidget(SHOW_LATE);
    } catch (IllegalStateException e) {
      // Nobody is typing any more.
    }
  }

  private boolean showLate(LineReader reader) {
    Question asked = pending;
    if (asked == null || asked.names().state() != Future.State.SUCCESS) {
      return true;
    }
    pending = null;
    Collection<String> found = asked.names().resultNow();
    if (!found.isEmpty() && reader.getBuffer().upToCursor().equals(asked.text())) {
      String common = commonBeginning(found);
      if (common.startsWith(asked.word()) && !common.equals(asked.word())) {
        reader.getBuffer().write(common.substring(asked.word().length()));
        reader.callWidget(LineReader.REDISPLAY);
      } else if (found.size() > 1) {
        reader.printAbove(inColumns(found, reader.getTerminal().getSize().getColumns()));
      }
    }
    return true;
  }

  private static String commonBeginning(Collection<String> names) {
    Iterator<String> each = names.iterator();
    String common = each.next();
    while (each.hasNext()) {
      String name = each.next();
      int same = 0;
      while (same < Math.min(common.length(), name.length())
          && common.charAt(same) == name.charAt(same)) {
        same++;
      }
      common = common.substring(0, same);
    }
    return common;
  }

  private static String inColumns(Collection<String> names, int width) {
    List<String> shown = names.stream().limit(MOST_SHOWN).toList();
    int column = 2 + shown.stream().mapToInt(String::length).max().orElse(0);
    int columns = Math.max(1, width / column);
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < shown.size(); i++) {
      boolean last = i % columns == columns - 1 || i == shown.size() - 1;
      String name = shown.get(i);
      text.append(name).append(last ? "\n" : " ".repeat(column - name.length()));
    }
    if (shown.size() < names.size()) {
      text.append("and ").append(names.size() - shown.size()).append(" more\n");
    }
    return text.toString();
  }
}
