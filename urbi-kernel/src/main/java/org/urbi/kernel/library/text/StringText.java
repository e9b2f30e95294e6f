package org.urbi.kernel.library.text;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.lang.text.StringDistance;

/** Strings as texts (manual, "String"): splitting, likeness, kinds of characters. */
@UrbiTypePart(value = "String", needs = Permission.NOTHING)
final class StringText {
  private static final List<String> SPACES = List.of(" ", "\t", "\n", "\r");

  /** So many characters are looked through at once. */
  private static final int PIECE = 1 << 16;

  private StringText() {}

  // ------------------------------------------------------------------ splitting

  @Builtin(
      doc = "The parts between separators: in at most lim cuts, with the separators if keepSep.")
  static List<UrbiObject> split(
      Frame caller,
      CallSite site,
      UrbiString self,
      @Optional @Nullable UrbiObject sep,
      @Optional @Nullable UrbiObject lim,
      @Optional @Nullable UrbiObject keepSep,
      @Optional @Nullable UrbiObject keepEmpty) {
    List<String> separators = SPACES;
    if (sep instanceof UrbiList list) {
      separators = new ArrayList<>();
      for (UrbiObject one : list.elements()) {
        caller.job().worked(1);
        separators.add(Arguments.text(caller, site, 1, one));
      }
    } else if (sep != null) {
      separators = List.of(Arguments.text(caller, site, 1, sep));
    }
    int limit =
        lim == null || lim == caller.interpreter().world().values().nil
            ? -1
            : Arguments.integer(caller, site, 2, lim);
    boolean withSeparators = keepSep != null && Truth.of(caller, keepSep);
    // Words are what is between spaces, however many.
    boolean withEmpty = keepEmpty == null ? sep != null : Truth.of(caller, keepEmpty);
    List<UrbiObject> parts = new ArrayList<>();
    for (String part :
        split(self.value(), separators, limit, withSeparators, withEmpty, caller.job())) {
      caller.job().worked(1);
      parts.add(StringType.string(caller, part));
    }
    return parts;
  }

  private static List<String> split(
      String text,
      List<String> separators,
      int limit,
      boolean keepSep,
      boolean keepEmpty,
      Job job) {
    if (separators.contains("")) {
      return characters(text, limit, job);
    }
    boolean isLetter = separators.size() == 1 && separators.getFirst().length() == 1;
    List<String> longestFirst = new ArrayList<>(separators);
    longestFirst.sort((one, other) -> {
      job.worked(1);
      return Integer.compare(other.length(), one.length());
    });
    List<String> parts = new ArrayList<>();
    int start = 0;
    int at = 0;
    int left = limit;
    while (at < text.length() && left != 0) {
      if (isLetter) {
        int end = at + Math.min(text.length() - at, PIECE);
        int next = text.indexOf(separators.getFirst().charAt(0), at, end);
        at = next < 0 ? end - 1 : next;
      }
      String found = separatorAt(text, at, longestFirst, job);
      if (found == null) {
        at++;
        continue;
      }
      addPart(parts, text.substring(start, at), keepEmpty);
      if (keepSep) {
        parts.add(found);
      }
      left--;
      at += found.length();
      start = at;
    }
    addPart(parts, text.substring(start), keepEmpty);
    return parts;
  }

  /** Cuts between all characters: the empty separator is found everywhere. */
  private static List<String> characters(String text, int limit, Job job) {
    List<String> parts = new ArrayList<>();
    int at = 0;
    while (at < text.length() - 1 && parts.size() != limit) {
      job.worked(1);
      parts.add(text.substring(at, ++at));
    }
    addPart(parts, text.substring(at), false);
    return parts;
  }

  private static @Nullable String separatorAt(
      String text, int at, List<String> separators, Job job) {
    for (String separator : separators) {
      job.worked(1 + Steps.ofCharacters(separator.length()));
      if (text.startsWith(separator, at)) {
        return separator;
      }
    }
    return null;
  }

  private static void addPart(List<String> parts, String part, boolean keepEmpty) {
    if (keepEmpty || !part.isEmpty()) {
      parts.add(part);
    }
  }

  // ------------------------------------------------------------------ likeness

  @Builtin(doc = "How many edits (Damerau-Levenshtein) make other of the target.")
  static int distance(Frame caller, UrbiString self, String other) {
    return StringDistance.distance(self.value(), other, caller.job()::checkInterrupted);
  }

  @Builtin(doc = "The most alike of a list of strings; nil if none is much alike.")
  static UrbiObject closest(Frame caller, CallSite site, UrbiString self, UrbiList set) {
    List<String> candidates = new ArrayList<>();
    for (UrbiObject one : set.elements()) {
      caller.job().worked(1);
      candidates.add(Arguments.text(caller, site, 1, one));
    }
    String closest =
        StringDistance.closest(self.value(), candidates, caller.job()::checkInterrupted);
    return closest == null
        ? caller.interpreter().world().values().nil
        : StringType.string(caller, closest);
  }

  // ------------------------------------------------------------------ kinds of characters

  @Builtin(doc = "Whether all characters are letters or digits.")
  static boolean isAlnum(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), Characters::isLetterOrDigit);
  }

  @Builtin(doc = "Whether all characters are letters.")
  static boolean isAlpha(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), Characters::isLetter);
  }

  @Builtin(doc = "Whether all characters are in ASCII.")
  static boolean isAscii(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), c -> c < 0x80);
  }

  @Builtin(doc = "Whether all are control characters.")
  static boolean isCntrl(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), Characters::isControl);
  }

  @Builtin(doc = "Whether all characters are digits.")
  static boolean isDigit(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), Characters::isDigit);
  }

  @Builtin(doc = "Whether all characters are visible.")
  static boolean isGraph(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), Characters::isVisible);
  }

  @Builtin(doc = "Whether all characters are lower case letters.")
  static boolean isLower(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), Characters::isLower);
  }

  @Builtin(doc = "Whether all characters are visible, or the space.")
  static boolean isPrint(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), c -> c == ' ' || Characters.isVisible(c));
  }

  @Builtin(doc = "Whether all characters are visible, but neither letters nor digits.")
  static boolean isPunct(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), Characters::isPunctuation);
  }

  @Builtin(doc = "Whether all are spaces, tabulations, ends of lines or of pages.")
  static boolean isSpace(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), Characters::isSpace);
  }

  @Builtin(doc = "Whether all characters are upper case letters.")
  static boolean isUpper(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), Characters::isUpper);
  }

  @Builtin(doc = "Whether all characters are hexadecimal digits.")
  static boolean isXdigit(Frame caller, UrbiString self) {
    return Characters.all(caller.job(), self.value(), Characters::isHexadecimal);
  }
}
