package org.urbi.kernel.library.code;

import java.util.List;
import java.util.Locale;
import org.urbi.kernel.node.Profiler;

/** A profile as people read it (manual, "Profile"). */
final class ProfileTable {
  private static final int SUMMARY_WIDTH = 30;
  private static final int NAME_WIDTH = 12;
  private static final long NANOSECONDS = 1_000;

  private final StringBuilder out = new StringBuilder("Profile(\n");
  private final List<Profiler.Calls> calls;
  private final int width;

  private ProfileTable(List<Profiler.Calls> calls) {
    this.calls = calls;
    this.width =
        calls.stream().mapToInt(each -> each.name().length()).reduce(NAME_WIDTH, Math::max);
  }

  /** The table; the functions come in the order given. */
  static String of(Profiler profiler, List<Profiler.Calls> calls) {
    ProfileTable table = new ProfileTable(calls);
    long total = calls.stream().mapToLong(each -> microseconds(each.self())).sum();
    table.summary("Yields", profiler.yields());
    table.summary("Total time (us)", total);
    table.summary("Wall-clock time (us)", microseconds(profiler.wallClock()));
    table.summary("Function calls", calls.stream().mapToLong(Profiler.Calls::count).sum());
    table.summary("Max depth", profiler.maximumDepth());
    table.out.append('\n');
    table.rows(total);
    return table.out.append(')').toString();
  }

  private static long microseconds(long nanoseconds) {
    return nanoseconds / NANOSECONDS;
  }

  private void summary(String label, long value) {
    String text = "  " + label + ":";
    String number = String.valueOf(value);
    out.append(text)
        .append(" ".repeat(Math.max(1, SUMMARY_WIDTH - text.length() - number.length())))
        .append(number)
        .append('\n');
  }

  private void rows(long total) {
    String rule = "-".repeat(width + 2);
    out.append("  .").append(rule).append("-".repeat(53)).append(".\n");
    row(centered("function"), "   %    ", " cumulative ", "  self  ", "  calls  ", "   self    ");
    row(centered(""), "        ", "    (us)    ", "  (us)  ", "         ", " (us/call) ");
    out.append("  |" + rule + "+--------+------------+--------+---------+-----------|\n");
    long cumulative = 0;
    for (Profiler.Calls each : calls) {
      long self = microseconds(each.self());
      cumulative += self;
      row(
          String.format(" %" + width + "s ", each.name()),
          String.format(Locale.ROOT, " %6.2f ", total == 0 ? 0 : 100.0 * self / total),
          String.format(" %10d ", cumulative),
          String.format(" %6d ", self),
          String.format(" %7d ", each.count()),
          String.format(" %9s ", ratio(self, each.count())));
    }
    out.append("  '" + rule + "'--------'------------'--------'---------'-----------'\n");
  }

  private void row(String... cells) {
    out.append("  |").append(String.join("|", cells)).append("|\n");
  }

  private String centered(String text) {
    int room = width + 2 - text.length();
    return " ".repeat(room / 2) + text + " ".repeat(room - room / 2);
  }

  private static String ratio(long time, long count) {
    return time % count == 0
        ? String.valueOf(time / count)
        : String.format(Locale.ROOT, "%.3f", (double) time / count);
  }
}
