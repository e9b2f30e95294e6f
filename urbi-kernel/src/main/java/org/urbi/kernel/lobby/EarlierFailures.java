package org.urbi.kernel.lobby;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Hint;
import org.urbi.kernel.error.UrbiException;
import org.urbi.lang.advice.Advice;
import org.urbi.lang.advice.SyntaxAdvice;
import org.urbi.lang.parse.SyntaxError;
import org.urbi.lang.source.Span;

/**
 * What a lobby lacks because something has failed, or was local, so that people are told the cause
 * of later errors, rather than what to do about each of them. Of the errors of a file that have the
 * same cause, they are told the first, and how many others there were.
 */
public final class EarlierFailures {
  /** How many names, and how many causes that have been told, are remembered. */
  private static final int MOST = 64;

  /** How many missing names that have caused errors are told. */
  private static final int MOST_TOLD = 6;

  /** How far before a failure its declaration is looked for: a program may be one long line. */
  private static final int LOOK_BACK = 200;

  private static final Pattern DECLARATION =
      Pattern.compile(
          "\\b(?:var\\s+(?:\\w+\\s*\\.\\s*)*(\\w+)\\s*=|class\\s+(\\w+)\\s*:)[^;|&{}]*$");

  /** The beginning of a statement that declares a name. */
  private static final Pattern DECLARING =
      Pattern.compile(
          "(?s)(?:\\s|//[^\n]*\n|/\\*.*?\\*/)*+(?:const\\s+)?(?<word>\\w+)\\s+"
              + "(?:\\w+\\s*\\.\\s*)*(?<name>\\w+)");

  private static final Pattern LOADING =
      Pattern.compile("(?:System\\.)?(?:load|loadFile|loadModule|require|requireFile)\\(.*");

  private final Map<String, Span> undeclared = new LinkedHashMap<>();
  private final Map<String, Span> local = new LinkedHashMap<>();
  private final Set<String> told = new HashSet<>();
  private final Set<String> lacking = new LinkedHashSet<>();
  private @Nullable Span notLoaded;
  private @Nullable String reading;
  private boolean counts;
  private int counted;

  /** Remembers what an exception that nobody has caught prevents. */
  public void add(UrbiException thrown) {
    List<UrbiException.Call> calls = thrown.backtrace();
    Span place = calls.isEmpty() ? thrown.span() : calls.getLast().span();
    if (place == null) {
      return;
    }
    String text = place.source().text();
    int begin = Math.min(place.begin(), text.length());
    Matcher declaration =
        DECLARATION.matcher(text.substring(Math.max(0, begin - LOOK_BACK), begin));
    if (declaration.find()) {
      addUndeclared(declaration.group(declaration.group(1) == null ? 2 : 1), place);
    }
    if (place.location().file() != null && LOADING.matcher(place.text()).matches()) {
      notLoaded = place;
      told.clear();
    }
  }

  /** Remembers what a statement that makes no sense would have declared. */
  public void add(SyntaxError error) {
    Matcher declaration = DECLARING.matcher(error.span().source().text());
    if (declaration.lookingAt()
        && declaration.start("name") <= error.span().begin()
        && SyntaxAdvice.isToDeclare(declaration.group("word"))) {
      addUndeclared(declaration.group("name"), error.span());
    }
  }

  private void addUndeclared(String name, Span place) {
    if (undeclared.size() < MOST) {
      undeclared.put(name, place);
      told.clear();
    }
  }

  /** Remembers the names that are known only within a statement that is run. */
  public void addLocal(Map<String, Span> names) {
    names.forEach((name, place) -> {
      local.remove(name);
      if (local.size() == MOST) {
        local.remove(local.keySet().iterator().next());
      }
      local.put(name, place);
    });
  }

  /** Where a name was declared that is known only there, or null. */
  public @Nullable Span localOf(String name) {
    return local.get(name);
  }

  /**
   * Why a name may be unknown, or null when nothing is known to be the cause.
   *
   * @param place where it is unknown
   */
  public @Nullable String causeOf(String name, @Nullable Span place) {
    Span declared = undeclared.get(name);
    if (declared != null) {
      return (counts ? Hint.NOT_DECLARED_IN_FILE : Hint.NOT_DECLARED)
          .text(name, declared.location());
    }
    // People who type see that loading has failed, and may have loaded it since.
    return notLoaded != null && isSameFile(notLoaded, place)
        ? Hint.NOT_LOADED.text(name, notLoaded.location())
        : null;
  }

  /**
   * Whether a statement of the file that is read has failed for a reason that people know, and they
   * know that such errors are counted; this one has been then.
   *
   * @param name what it lacks
   */
  public boolean counts(String name, @Nullable Span place) {
    Span declared = undeclared.get(name);
    if (declared == null || !isReading(declared) || place == null || !isReading(place)) {
      return false;
    }
    boolean known = counts;
    counts = true;
    if (known) {
      counted++;
      lacking.add(name);
    }
    return known;
  }

  private boolean isReading(Span place) {
    return reading != null && reading.equals(place.location().file());
  }

  /** Whether a cause has not been told since something has failed that others may need. */
  public boolean isNews(String cause) {
    if (told.size() == MOST) {
      told.clear();
    }
    return told.add(cause);
  }

  /**
   * Goes on to what is executed next: how many errors of a file have been counted is told behind
   * its last statement.
   *
   * @param file in which that stands; null when it is in none, or nothing is left
   */
  public void reads(@Nullable String file, Output output) {
    if (Objects.equals(file, reading)) {
      return;
    }
    if (counted > 0 && reading != null) {
      String names =
          lacking.stream()
              .limit(MOST_TOLD)
              .map(name -> "`" + name + "'")
              .collect(Collectors.joining(", ", "", lacking.size() > MOST_TOLD ? ", …" : ""));
      String hint = Hint.FOLLOWING.text(counted, counted == 1 ? "" : "s", reading, names);
      Diagnostics.explain(output, null, () -> Advice.of(hint));
    }
    reading = file;
    counts = false;
    counted = 0;
    lacking.clear();
  }

  private static boolean isSameFile(Span one, @Nullable Span other) {
    String file = one.location().file();
    return file != null && other != null && file.equals(other.location().file());
  }
}
