package org.urbi.lang.advice;

import java.lang.reflect.RecordComponent;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.problem.SyntaxHint;
import org.urbi.lang.source.Span;

/** Code that is valid, but does something else than who typed it may think. */
public final class SuspectCode {
  private static final Pattern SIGN = Pattern.compile("\\s*(?<operator>=(?<sign>[-+]))\\s");
  private static final Set<String> VALUES = Set.of("true", "false", "nil", "void");

  /** The motions that go on for ever. */
  private static final Set<String> ENDLESS = Set.of("sin", "cos");

  /** <code>${name}</code>. */
  private static final Pattern INTERPOLATED = Pattern.compile("\\$\\{(\\w+)\\}");

  private SuspectCode() {}

  /**
   * What looks like a mistake in a statement.
   *
   * @param separator what ended it
   */
  public static List<Note> in(Ast statement, Ast.@Nullable Flavor separator) {
    List<Note> found = new ArrayList<>();
    if (separator == Ast.Flavor.SEMICOLON && isEndless(statement)) {
      found.add(new Note(statement.span(), SyntaxHint.ENDLESS.text()));
    }
    walk(
        statement,
        each -> {
          condition(each, found);
          if (each instanceof Ast.Assignment assignment) {
            sign(assignment, found);
            value(assignment, found);
          } else if (each instanceof Ast.Declaration declaration) {
            value(declaration, found);
          } else if (each instanceof Ast.Message call
              && call.target() == null
              && call.name().equals("echo")
              && call.arguments() != null) {
            call.arguments().forEach(shown -> interpolated(shown, found));
          }
        });
    return found;
  }

  /**
   * What looks like a mistake in two statements in a row: {@code x, y = 1, 2}.
   *
   * @param separator what ended the first
   */
  public static List<Note> between(Ast first, Ast.@Nullable Flavor separator, Ast second) {
    boolean several =
        separator == Ast.Flavor.COMMA
            && isName(first)
            && second instanceof Ast.Assignment assignment
            && isName(assignment.target())
            && first.span().location().endLine() == second.span().location().line();
    return several
        ? List.of(new Note(second.span(), SyntaxHint.ONE_BY_ONE.text(first.span().text())))
        : List.of();
  }

  private static boolean isName(Ast code) {
    return code instanceof Ast.Message name && name.target() == null && name.arguments() == null;
  }

  /** <code>echo("${name}")</code>, also where strings are joined. */
  private static void interpolated(Ast shown, List<Note> found) {
    if (shown instanceof Ast.Message sum && sum.name().equals("+") && sum.arguments() != null) {
      if (sum.target() != null) {
        interpolated(sum.target(), found);
      }
      sum.arguments().forEach(part -> interpolated(part, found));
    } else if (shown instanceof Ast.StringLiteral text) {
      Matcher place = INTERPOLATED.matcher(text.value());
      if (place.find()) {
        found.add(
            new Note(text.span(), SyntaxHint.INTERPOLATED.text(place.group(), place.group(1))));
      }
    }
  }

  /** {@code every (1s) …;}, {@code x = 0 sin:2s;} keep the input that follows waiting. */
  private static boolean isEndless(Ast statement) {
    boolean loops =
        statement instanceof Ast.Every
            || statement instanceof Ast.Loop
            || statement instanceof Ast.Trajectory motion
                && motion.modifiers().stream().anyMatch(each -> ENDLESS.contains(each.name()))
            || statement instanceof Ast.Tagged tagged && isEndless(tagged.body());
    if (!loops) {
      return false;
    }
    boolean[] ends = new boolean[1];
    walk(statement, each -> ends[0] |= each instanceof Ast.Break || each instanceof Ast.Throw);
    return !ends[0];
  }

  /** {@code if (x = 1) …}, {@code if (x & 1) …}. */
  private static void condition(Record code, List<Note> found) {
    @Nullable Ast condition =
        switch (code) {
          case Ast.If choice -> choice.condition();
          case Ast.While loop -> loop.condition();
          case Ast.WhenTrue when -> when.expression();
          default -> null;
        };
    if (condition instanceof Ast.Assignment assignment) {
      found.add(new Note(assignment.span(), SyntaxHint.COMPARISON.text()));
    } else if (condition instanceof Ast.Sequence parts
        && !parts.separators().contains(Ast.Flavor.SEMICOLON)) {
      found.add(new Note(parts.span(), SyntaxHint.COMPOSED.text()));
    }
  }

  /** {@code x =+ 1}, but not {@code x = +1} or {@code x =-1}. */
  private static void sign(Ast.Assignment assignment, List<Note> found) {
    Span all = assignment.span();
    Span target = assignment.target().span();
    Matcher operator = SIGN.matcher(all.source().text()).region(target.end(), all.end());
    if (operator.lookingAt()) {
      String sign = operator.group("sign");
      Span place = new Span(all.source(), operator.start("operator"), operator.end("operator"));
      found.add(new Note(place, SyntaxHint.SIGN.text(sign, sign)));
    }
  }

  /** {@code true = 1}. These are names like others, so that it is allowed. */
  private static void value(Ast.Assignment assignment, List<Note> found) {
    if (isName(assignment.target())
        && assignment.target() instanceof Ast.Message name
        && VALUES.contains(name.name())) {
      found.add(new Note(name.span(), SyntaxHint.VALUE.text(name.name())));
    }
  }

  /** {@code var true = 1}, but not {@code var o.true}, which is found only by that object. */
  private static void value(Ast.Declaration declaration, List<Note> found) {
    if (declaration.target() == null && VALUES.contains(declaration.name())) {
      found.add(new Note(declaration.nameSpan(), SyntaxHint.VALUE.text(declaration.name())));
    }
  }

  /** The calls of names with empty parentheses in a statement: {@code Tag()}. */
  public static List<Ast.Message> emptyCalls(Ast statement) {
    return messages(statement, call -> call.arguments() != null && call.arguments().isEmpty());
  }

  /** Where a name stands alone in a statement. */
  public static List<Ast.Message> uses(Ast statement, String name) {
    return messages(statement, use -> use.arguments() == null && use.name().equals(name));
  }

  /** What is asked of nobody in particular in a statement, and is so. */
  private static List<Ast.Message> messages(Ast statement, Predicate<Ast.Message> isSo) {
    List<Ast.Message> found = new ArrayList<>();
    walk(
        statement,
        each -> {
          if (each instanceof Ast.Message message
              && message.target() == null
              && isSo.test(message)) {
            found.add(message);
          }
        });
    return found;
  }

  /** Shows a tree and all that is in it, in the order of the text; it may be very deep. */
  static void walk(Ast tree, Consumer<Record> visitor) {
    Deque<Object> left = new ArrayDeque<>();
    left.push(tree);
    while (!left.isEmpty()) {
      Object part = left.pop();
      if (part instanceof List<?> parts) {
        parts.reversed().forEach(left::push);
      } else if (part instanceof Record node && isOfTree(node)) {
        visitor.accept(node);
        List<RecordComponent> components = List.of(node.getClass().getRecordComponents());
        for (RecordComponent component : components.reversed()) {
          Object value = value(node, component);
          if (value != null) {
            left.push(value);
          }
        }
      }
    }
  }

  private static boolean isOfTree(Record node) {
    return node.getClass().getEnclosingClass() == Ast.class;
  }

  private static @Nullable Object value(Record node, RecordComponent component) {
    try {
      return component.getAccessor().invoke(node);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }
}
