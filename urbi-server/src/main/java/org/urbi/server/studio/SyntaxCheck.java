package org.urbi.server.studio;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;
import org.urbi.lang.parse.ParseResult;
import org.urbi.lang.parse.SyntaxError;
import org.urbi.lang.parse.UrbiParser;
import org.urbi.lang.source.Span;

/** Looks for syntax errors in texts that people are typing, one text after the other. */
final class SyntaxCheck implements AutoCloseable {
  /** How long a text is looked at, in nanoseconds. */
  private static final long LONGEST = 500_000_000;

  /**
   * What is wrong at some place.
   *
   * @param begin the first character that is wrong
   * @param end the character behind the last one
   * @param text for people
   */
  record Mistake(int begin, int end, String text) {}

  /** It takes too long. */
  private static final class TooLong extends RuntimeException {
    private static final long serialVersionUID = 1;

    TooLong() {
      super(null, null, false, false);
    }
  }

  private final Clock clock = new SystemClock();
  private final Worker worker = new Worker("urbi-studio-syntax");

  /**
   * Looks for errors.
   *
   * @return the errors; done exceptionally if the text is too much for that, or nobody is served
   *     any more
   */
  CompletableFuture<List<Mistake>> check(String text) {
    return worker.ask(() -> mistakes(text));
  }

  /** Why there is no answer, for people; a defect of ours is logged. */
  static String reason(Throwable failure) {
    if (failure instanceof TooLong
        || failure instanceof StackOverflowError
        || failure instanceof RejectedExecutionException) {
      return "this text is too much to be checked";
    }
    FailureLog.internal("the look for mistakes", failure);
    return FailureLog.text(failure);
  }

  private List<Mistake> mistakes(String text) {
    long end = clock.now() + LONGEST;
    ParseResult parsed =
        UrbiParser.parse(
            Utf8Text.toUrbi(text),
            null,
            () -> {
              if (clock.now() - end > 0) {
                throw new TooLong();
              }
            });
    return parsed.errors().stream().map(error -> mistake(text, error)).toList();
  }

  private static Mistake mistake(String text, SyntaxError error) {
    Span span = error.span();
    return new Mistake(place(text, span.begin()), place(text, span.end()), error.message());
  }

  /** Where the byte of that number of the text in UTF-8 is. */
  private static int place(String text, int bytes) {
    int at = 0;
    int passed = 0;
    while (at < text.length() && passed < bytes) {
      int character = text.codePointAt(at);
      at += Character.charCount(character);
      passed += character < 0x80 ? 1 : character < 0x800 ? 2 : character < 0x10000 ? 3 : 4;
    }
    return at;
  }

  @Override
  public void close() {
    worker.close();
  }
}
