package org.urbi.kernel.library.text;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.PatternSyntaxException;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.library.lobby.Warnings;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.lang.print.StringEscape;

/** Regular expressions, with the syntax of Perl (manual, "Regexp"). */
@UrbiType(
    value = "Regexp",
    protos = {"Container", "Object"},
    doc = "A regular expression, with the syntax of Perl.",
    needs = Permission.NOTHING)
final class RegexpType {
  /**
   * Compiling a longer one would take long, and cannot be ended: where it looks behind, the JDK
   * looks through the rest of it each time.
   */
  private static final int LONGEST_EXPRESSION = 1 << 14;

  private static final int SHOWN_OF_LONG = 100;

  private RegexpType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiRegexp(world.values().object.cloneShape(), ".", RegexpSyntax.compile("."));
  }

  @Builtin(doc = "Makes it the regular expression of that text.", needs = Permission.CHANGE)
  static UrbiObject init(Frame caller, CallSite site, UrbiRegexp self, String text) {
    if (text.isEmpty()) {
      throw invalid(caller, site, text, Problem.EMPTY_EXPRESSION.text());
    }
    if (text.length() > LONGEST_EXPRESSION) {
      String beginning = text.substring(0, SHOWN_OF_LONG);
      throw invalid(caller, site, beginning, Problem.EXPRESSION_TOO_LONG.text());
    }
    try {
      self.setPattern(text, RegexpSyntax.compile(text));
      return self;
    } catch (PatternSyntaxException e) {
      throw invalid(caller, site, text, RegexpSyntax.reason(text, e));
    }
  }

  private static UrbiException invalid(Frame caller, CallSite site, String text, String reason) {
    return caller.error(site, Problem.REGULAR_EXPRESSION, text, reason);
  }

  @Builtin(doc = "The regular expression, to be shown.")
  static String asPrintable(UrbiRegexp self) {
    return "Regexp(" + StringEscape.quote(self.text()) + ")";
  }

  @Builtin(doc = "The text of the regular expression.")
  static String asString(UrbiRegexp self) {
    return self.text();
  }

  @Builtin(
      value = {"match", "has"},
      doc = "Whether a part of a string matches.")
  static boolean match(Frame caller, UrbiRegexp self, String str) {
    Matcher matcher = self.pattern().matcher(new InterruptibleText(str, caller.job()));
    // It is about the whole text; so they only make it ask for the length: RegexpTranslation.
    matcher.useTransparentBounds(true).useAnchoringBounds(false);
    boolean found = matcher.find();
    int[] groups = new int[found ? 2 * (matcher.groupCount() + 1) : 0];
    for (int i = 0; i < groups.length; i += 2) {
      groups[i] = matcher.start(i / 2);
      groups[i + 1] = matcher.end(i / 2);
    }
    if (PermissionCheck.allowsChange(caller, self)) {
      self.setMatch(found ? str : "", groups);
    }
    return found;
  }

  @Builtin(doc = "The groups of the last match, the whole of it first; empty if it failed.")
  static List<UrbiObject> matches(Frame caller, UrbiRegexp self) {
    List<UrbiObject> strings = new ArrayList<>();
    for (int i = 0; i < self.groups(); i++) {
      String group = self.group(i);
      caller.job().worked(Steps.OBJECT + Steps.ofCharacters(group.length()));
      strings.add(StringType.string(caller, group));
    }
    return strings;
  }

  @Builtin(doc = "Deprecated: use matches.")
  static List<UrbiObject> matchs(Frame caller, CallSite site, UrbiRegexp self) {
    Warnings.deprecated(caller, "Regexp.matchs", "Regexp.matches");
    return matches(caller, self);
  }

  @Builtin(value = "[]", doc = "A group of the last match; the whole of it is number 0.")
  static String get(Frame caller, CallSite site, UrbiRegexp self, int n) {
    if (n < 0 || n >= self.groups()) {
      throw caller.error(site, Problem.GROUP_OUT_OF_BOUNDS, n);
    }
    return self.group(n);
  }
}
