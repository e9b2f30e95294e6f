package org.urbi.kernel.lobby;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Hint;
import org.urbi.kernel.error.UrbiException;
import org.urbi.lang.source.Span;

/**
 * What a lobby lacks because something has failed, or was local, so that people are told the cause
 * of what goes wrong for want of it, rather than what to do about each consequence.
 */
public final class EarlierFailures {
  /** How many names, and how many causes that have been told, are remembered. */
  private static final int MOST = 64;

  /** How far before a failure its declaration is looked for: a program may be one long line. */
  private static final int LOOK_BACK = 200;

  private static final Pattern DECLARATION =
      Pattern.compile(
          "\\b(?:var\\s+(?:\\w+\\s*\\.\\s*)*(\\w+)\\s*=|class\\s+(\\w+)\\s*:)[^;|&{}]*$");

  private static final Pattern LOADING =
      Pattern.compile("(?:System\\.)?(?:load|loadFile|loadModule|require|requireFile)\\(.*");

  private final Map<String, Span> undeclared = new LinkedHashMap<>();
  private final Map<String, Span> local = new LinkedHashMap<>();
  private final Set<String> told = new HashSet<>();
  private @Nullable Span notLoaded;

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
    if (declaration.find() && undeclared.size() < MOST) {
      String name = declaration.group(declaration.group(1) == null ? 2 : 1);
      undeclared.put(name, place);
      told.clear();
    }
    if (place.location().file() != null && LOADING.matcher(place.text()).matches()) {
      notLoaded = place;
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
      return Hint.NOT_DECLARED.text(name, declared.location());
    }
    // People who type see that loading has failed, and may have loaded it since.
    return notLoaded != null && place != null && isSameFile(notLoaded, place)
        ? Hint.NOT_LOADED.text(name, notLoaded.location())
        : null;
  }

  /** Whether a cause has not been told since something has failed that others may need. */
  public boolean isNews(String cause) {
    if (told.size() == MOST) {
      told.clear();
    }
    return told.add(cause);
  }

  private static boolean isSameFile(Span one, Span other) {
    String file = one.location().file();
    return file != null && file.equals(other.location().file());
  }
}
