package org.urbi.lang.advice;

import java.lang.reflect.RecordComponent;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.problem.SyntaxHint;

/** Code that is valid, but does something else than who typed it may think. */
public final class SuspectCode {
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
    walk(statement, each -> condition(each, found));
    return found;
  }

  /** {@code every (1s) …;} keeps the input that follows waiting. */
  private static boolean isEndless(Ast statement) {
    boolean loops =
        statement instanceof Ast.Every
            || statement instanceof Ast.Loop
            || statement instanceof Ast.Tagged tagged && isEndless(tagged.body());
    if (!loops) {
      return false;
    }
    boolean[] ends = new boolean[1];
    walk(statement, each -> ends[0] |= each instanceof Ast.Break || each instanceof Ast.Throw);
    return !ends[0];
  }

  /** {@code if (x = 1) …}. */
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
    }
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
