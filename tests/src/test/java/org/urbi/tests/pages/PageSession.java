package org.urbi.tests.pages;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.urbi.tests.OutputNormalizer;
import org.urbi.tests.Transcript;

/**
 * Listings that are one session: what the reader types, and below it what is answered, with the
 * time since the listing began. Locations count from the first line of the listing.
 */
final class PageSession {
  private static final String CHANNEL = "page";

  /**
   * Lets what the last statements have set off have its say, without time passing, before what
   * follows is marked.
   */
  private static final String SETTLE = "for (4) sleep(0);";

  private static final Pattern MARK = Pattern.compile("\\[(\\d+):" + CHANNEL + "] (\\d+)");
  private static final Pattern STAMP = Pattern.compile("^\\[(\\d{8,})(.*)");

  /**
   * Lines that are typed, and those that answer them.
   *
   * @param line of the listing, counted without answers, on which it begins
   * @param ends whether it is the last one of its listing
   */
  private record Exchange(int line, List<String> typed, List<String> shown, boolean ends) {}

  private final List<List<Exchange>> listings;

  private PageSession(List<List<Exchange>> listings) {
    this.listings = listings;
  }

  static PageSession of(List<Listing> listings) {
    return new PageSession(listings.stream().map(PageSession::exchanges).toList());
  }

  private static List<Exchange> exchanges(Listing listing) {
    List<Exchange> exchanges = new ArrayList<>();
    List<String> typed = new ArrayList<>();
    List<String> shown = new ArrayList<>();
    int line = 1;
    for (String text : listing.lines()) {
      if (Transcript.isOutput(text)) {
        shown.add(text);
        continue;
      }
      if (!shown.isEmpty()) {
        exchanges.add(new Exchange(line, List.copyOf(typed), List.copyOf(shown), false));
        line += typed.size();
        typed.clear();
        shown.clear();
      }
      typed.add(text);
    }
    exchanges.add(new Exchange(line, List.copyOf(typed), List.copyOf(shown), true));
    return exchanges;
  }

  /** What a kernel is fed: all that is typed, with a mark behind each exchange. */
  String program() {
    StringBuilder program = new StringBuilder();
    int mark = 0;
    for (List<Exchange> listing : listings) {
      for (Exchange exchange : listing) {
        program.append("//#push ").append(exchange.line()).append('\n');
        exchange.typed().forEach(line -> program.append(line).append('\n'));
        program.append("//#pop\n").append(SETTLE);
        if (exchange.ends()) {
          // What comes late belongs to the listing that it comes from.
          program.append("sleep(1ms)|;");
        }
        program.append("Channel.new(\"%s\") << %d;\n".formatted(CHANNEL, mark++));
      }
    }
    return program.toString();
  }

  /**
   * Each listing as it has to be, by what a kernel has answered.
   *
   * @throws AssertionError if the session ended before the page
   */
  List<List<String>> renewed(String output) {
    List<List<String>> answers = new ArrayList<>();
    List<Long> times = new ArrayList<>();
    List<String> current = new ArrayList<>();
    for (String line : output.lines().toList()) {
      Matcher mark = MARK.matcher(line);
      if (mark.matches()) {
        answers.add(current);
        times.add(Long.parseLong(mark.group(1)));
        current = new ArrayList<>();
      } else {
        current.add(line);
      }
    }
    int count = listings.stream().mapToInt(List::size).sum();
    if (answers.size() != count) {
      throw new AssertionError(
          "the session ends after %d of %d exchanges:\n%s"
              .formatted(answers.size(), count, String.join("\n", current)));
    }
    List<List<String>> renewed = new ArrayList<>();
    int next = 0;
    long start = 0;
    for (List<Exchange> listing : listings) {
      List<String> lines = new ArrayList<>();
      for (Exchange exchange : listing) {
        lines.addAll(exchange.typed());
        answers.get(next).stream().map(since(start)).forEach(lines::add);
        next++;
      }
      start = times.get(next - 1);
      renewed.add(lines);
    }
    return renewed;
  }

  private static UnaryOperator<String> since(long start) {
    return line -> {
      Matcher stamp = STAMP.matcher(line);
      return stamp.matches()
          ? "[%08d%s".formatted(Long.parseLong(stamp.group(1)) - start, stamp.group(2))
          : "[:]" + line;
    };
  }

  /**
   * The lines of a listing, without what differs from run to run: addresses and numbers of jobs,
   * and times unless they are asked for.
   */
  static List<String> comparable(List<String> lines, boolean withTimes) {
    List<String> result = new ArrayList<>();
    for (String line : lines) {
      result.addAll(
          Transcript.isOutput(line)
              ? OutputNormalizer.comparable(List.of(line), withTimes, true)
              : List.of(line));
    }
    return result;
  }
}
