package org.urbi.server.options;

import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Parses simple, correct command lines without picocli, which would double the start-up time of a
 * short script: its classes have a format that the start-up cache does not support. All other
 * command lines (mistakes, help, several letters after one dash) are left to picocli.
 */
final class FastParser {
  private final List<Option> options;
  private final boolean stopAtArgument;

  FastParser(List<Option> options, boolean stopAtArgument) {
    this.options = options;
    this.stopAtArgument = stopAtArgument;
  }

  /** The parsed command line, or nothing if it is not that simple. */
  Optional<ParsedCommandLine> read(String... args) {
    ParsedCommandLine reading = new ParsedCommandLine();
    Iterator<String> words = Arrays.asList(args).iterator();
    while (words.hasNext()) {
      String word = words.next();
      if (word.startsWith("-")) {
        if (!readOption(word, words, reading)) {
          return Optional.empty();
        }
      } else {
        reading.rest().add(word);
        if (stopAtArgument) {
          words.forEachRemaining(reading.rest()::add);
        }
      }
    }
    return Optional.of(reading);
  }

  private boolean readOption(String word, Iterator<String> words, ParsedCommandLine reading) {
    boolean isLong = word.startsWith("--");
    int equals = word.indexOf('=');
    int end = isLong ? equals < 0 ? word.length() : equals : Math.min(2, word.length());
    Option option = find(word.substring(0, end));
    if (option == null) {
      return false;
    }
    boolean attached = end < word.length();
    String value = null;
    if (option.hasValue()) {
      if (!attached && option.implied() == null && !words.hasNext()) {
        return false;
      }
      value =
          attached
              ? word.substring(equals == end ? end + 1 : end)
              : option.implied() == null ? words.next() : option.implied();
    } else if (attached) {
      return false;
    }
    reading.options().add(new ParsedCommandLine.Occurrence(option, value));
    return true;
  }

  private @Nullable Option find(String name) {
    for (Option option : options) {
      if (option.names().contains(name)) {
        return option;
      }
    }
    return null;
  }
}
