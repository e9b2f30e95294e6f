package org.urbi.kernel.library.text;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.library.value.Counting;
import org.urbi.kernel.library.value.Hashing;
import org.urbi.kernel.library.value.Printing;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** Strings (manual, "String"): operators, conversions and parts. */
@UrbiType(
    value = "String",
    protos = {"Comparable", "Orderable", "RangeIterable"},
    doc = "A sequence of characters.",
    needs = Permission.NOTHING)
public final class StringType {
  /** So many pairs of characters may be compared between two checks whether to continue. */
  private static final int SEARCHED = 1 << 20;

  /** Reading a longer number cannot be ended; and nobody means it. */
  private static final int LONGEST_NUMBER = 1 << 20;

  private StringType() {}

  static UrbiString string(Frame caller, String value) {
    return caller.interpreter().world().values().string(value);
  }

  // ------------------------------------------------------------------ conversions

  @Builtin(doc = "Makes it the same string as another one.", needs = Permission.CHANGE)
  static UrbiObject init(UrbiString self, @Optional @Nullable String value) {
    if (value != null) {
      self.setValue(value);
    }
    return self;
  }

  @Builtin(doc = "The string as a FormatInfo says.")
  static String format(Frame caller, CallSite site, UrbiString self, UrbiFormatInfo finfo) {
    return Formatting.format(caller, site.calledName(), self, finfo);
  }

  @Builtin(doc = "Whether it is not empty.")
  static boolean asBool(UrbiString self) {
    return !self.value().isEmpty();
  }

  @Builtin(doc = "The number that the whole string denotes.")
  static double asFloat(Frame caller, CallSite site, UrbiString self) {
    Double number = parseNumber(self.value());
    if (number == null) {
      throw caller.error(site, Problem.NOT_A_NUMBER, Printing.quoted(caller, self.value()));
    }
    return number;
  }

  static @Nullable Double parseNumber(String text) {
    String digits = text.startsWith("-") || text.startsWith("+") ? text.substring(1) : text;
    double sign = text.startsWith("-") ? -1 : 1;
    if (digits.equals("inf")) {
      return sign * Double.POSITIVE_INFINITY;
    }
    if (digits.equals("nan")) {
      return Double.NaN;
    }
    return digits.length() <= LONGEST_NUMBER && isNumber(digits)
        ? sign * Double.parseDouble(digits)
        : null;
  }

  /** Whether it is all digits, with a point or not, and perhaps an exponent. */
  private static boolean isNumber(String text) {
    int point = afterDigits(text, 0);
    int end = startsWithAny(text, point, '.', '.') ? afterDigits(text, point + 1) : point;
    if (point == 0 && end <= 1) {
      return false;
    }
    if (startsWithAny(text, end, 'e', 'E')) {
      int digits = startsWithAny(text, end + 1, '-', '+') ? end + 2 : end + 1;
      end = afterDigits(text, digits);
      if (end == digits) {
        return false;
      }
    }
    return end == text.length();
  }

  /** The index behind the digits that begin at an index. */
  private static int afterDigits(String text, int from) {
    int at = from;
    while (at < text.length() && text.charAt(at) >= '0' && text.charAt(at) <= '9') {
      at++;
    }
    return at;
  }

  private static boolean startsWithAny(String text, int at, char one, char other) {
    return at < text.length() && (text.charAt(at) == one || text.charAt(at) == other);
  }

  @Builtin(doc = "The list of its characters, as strings.")
  static List<UrbiObject> asList(Frame caller, UrbiString self) {
    String text = self.value();
    List<UrbiObject> characters = new ArrayList<>(text.length());
    for (int i = 0; i < text.length(); i++) {
      caller.job().worked(Steps.OBJECT);
      characters.add(string(caller, text.substring(i, i + 1)));
    }
    return characters;
  }

  @Builtin(doc = "The string as a literal.")
  static String asPrintable(Frame caller, UrbiString self) {
    return Printing.quoted(caller, self.value());
  }

  @Builtin(doc = "The target.")
  static UrbiObject asString(UrbiString self) {
    return self;
  }

  @Builtin(doc = "A Hash, equal for equal strings.")
  static UrbiHash hash(Frame caller, UrbiString self) {
    return Hashing.hash(caller, Hashing.code(caller, self.value()));
  }

  @Builtin(doc = "The character of a code, from 0 to 255.")
  static String fromAscii(Frame caller, CallSite site, UrbiObject self, int v) {
    if (v < 0 || v > 255) {
      throw caller.error(site, Problem.CHARACTER_CODE, v);
    }
    return String.valueOf((char) v);
  }

  @Builtin(doc = "The code of the first character.")
  static int toAscii(Frame caller, CallSite site, UrbiString self) {
    if (self.value().isEmpty()) {
      throw caller.error(site, Problem.EMPTY_STRING);
    }
    return self.value().charAt(0);
  }

  @Builtin(doc = "A string that no identifier has been so far, and that begins with the target.")
  static String fresh(Frame caller, UrbiString self) {
    return self.value() + "_" + caller.interpreter().world().count("String.fresh", 5);
  }

  // ------------------------------------------------------------------ operators

  @Builtin(value = "==", doc = "Whether that is the same string.")
  static boolean equals(UrbiString self, UrbiObject that) {
    return that instanceof UrbiString other && self.value().equals(other.value());
  }

  @Builtin(value = "!=", doc = "Whether that is not the same string.")
  static boolean differs(UrbiString self, UrbiObject that) {
    return !equals(self, that);
  }

  @Builtin(value = "<", doc = "Whether it comes before other in lexicographic order.")
  static boolean less(UrbiString self, String other) {
    return self.value().compareTo(other) < 0;
  }

  @Builtin(value = "+", doc = "The target followed by the asString of other.")
  static UrbiObject plus(Frame caller, UrbiString self, UrbiObject other) {
    Interpreter interpreter = caller.interpreter();
    String added = interpreter.asString(caller, other);
    Counting.checkMemory(caller, added.length());
    return interpreter.values().concatenation(self, added);
  }

  @Builtin(value = "*", doc = "The target so many times.")
  static String multiply(Frame caller, CallSite site, UrbiString self, UrbiFloat n) {
    return self.value().repeat(Counting.ofStrings(caller, site, 1, n, self.value().length()));
  }

  @Builtin(value = "%", doc = "The target as a format string, filled with args.")
  static String format(Frame caller, CallSite site, UrbiString self, UrbiObject args) {
    return FormatterType.format(caller, site, self.value(), args);
  }

  // ------------------------------------------------------------------ parts

  @Builtin(
      value = {"size", "length"},
      doc = "The number of characters.")
  static int size(UrbiString self) {
    return self.value().length();
  }

  @Builtin(doc = "Whether it has no characters.")
  static boolean empty(UrbiString self) {
    return self.value().isEmpty();
  }

  @Builtin(value = "[]", doc = "The characters from an index to another one, which is excluded.")
  static String get(
      Frame caller, CallSite site, UrbiString self, int from, @Optional @Nullable Integer to) {
    int[] bounds = bounds(caller, site, self.length(), from, to);
    return self.part(bounds[0], bounds[1]);
  }

  @Builtin(
      value = "[]=",
      doc = "Replaces the characters from an index, to another one; in place.",
      needs = Permission.CHANGE)
  static UrbiObject set(
      Frame caller,
      CallSite site,
      UrbiString self,
      int from,
      UrbiObject toOrOther,
      @Optional @Nullable String other) {
    Integer to = other == null ? null : Arguments.integer(caller, site, 2, toOrOther);
    UrbiObject given = other == null ? toOrOther : string(caller, other);
    String inserted = Arguments.text(caller, site, other == null ? 2 : 3, given);
    int[] bounds = bounds(caller, site, self.length(), from, to);
    self.replace(bounds[0], bounds[1], inserted);
    return given;
  }

  /** Where a range begins and ends; without an end it has one character. */
  private static int[] bounds(
      Frame caller, CallSite site, int size, int from, @Nullable Integer to) {
    int end = to == null ? from + 1 : to;
    if (from < 0 || from > size || (to == null && from == size)) {
      throw Counting.invalidIndex(caller, site, from);
    }
    if (end < from || end > size) {
      throw Counting.invalidIndex(caller, site, end);
    }
    return new int[] {from, end};
  }

  @Builtin(
      doc = "Makes it the same string as another one, in place; returns the target.",
      needs = Permission.CHANGE)
  static UrbiObject set(UrbiString self, String value) {
    self.setValue(value);
    return self;
  }

  @Builtin(doc = "The target with all that is from replaced by to.")
  static String replace(Frame caller, CallSite site, UrbiString self, String from, String to) {
    if (from.isEmpty()) {
      throw caller.error(site, Problem.REPLACES_EMPTY_STRING);
    }
    return replace(caller, self.value(), from, to);
  }

  /**
   * A search may look at nearly all of the pattern for each character of the text, so that it takes
   * place in pieces, the shorter the longer the pattern.
   */
  private static String replace(Frame caller, String text, String from, String to) {
    Job job = caller.job();
    int piece = Math.max(1, SEARCHED / from.length());
    StringBuilder out = new StringBuilder();
    int copied = 0;
    int at = 0;
    int last = text.length() - from.length();
    while (at <= last) {
      int begins = at + Math.min(piece, last + 1 - at);
      int found = text.indexOf(from, at, begins + from.length() - 1);
      if (found < 0) {
        job.worked(Steps.ofCharacters((long) (begins - at) * from.length()));
        at = begins;
      } else {
        job.worked(
            Steps.OBJECT + Steps.ofCharacters((long) (found - at) * from.length() + to.length()));
        out.append(text, copied, found);
        Counting.checkMemory(caller, (long) out.length() + to.length());
        out.append(to);
        copied = found + from.length();
        at = copied;
      }
    }
    return copied == 0 ? text : out.append(text, copied, text.length()).toString();
  }

  @Builtin(doc = "The target in lower case.")
  static String toLower(Frame caller, UrbiString self) {
    return Characters.lower(caller.job(), self.value());
  }

  @Builtin(doc = "The target in upper case.")
  static String toUpper(Frame caller, UrbiString self) {
    return Characters.upper(caller.job(), self.value());
  }

  @Builtin(doc = "The asString of the members of a list, with the target between them.")
  public static String join(
      Frame caller, UrbiString self, UrbiList list, String prefix, String suffix) {
    return join(caller, self.value(), list.elements(), prefix, suffix);
  }

  /** Strings one after the other. */
  public static String join(
      Frame caller, String separator, List<UrbiObject> elements, String prefix, String suffix) {
    Counting.checkMemory(caller, (long) prefix.length() + suffix.length());
    StringBuilder out = new StringBuilder(prefix);
    boolean first = true;
    for (UrbiObject element : List.copyOf(elements)) {
      out.append(first ? "" : separator);
      first = false;
      String text = caller.interpreter().asString(caller, element);
      caller.job().worked(Steps.OBJECT + Steps.ofCharacters(text.length() + separator.length()));
      Counting.checkMemory(caller, (long) out.length() + text.length());
      out.append(text);
    }
    return out.append(suffix).toString();
  }
}
