package org.urbi.kernel.node;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Literals: each evaluation creates a new object. */
public final class Literals {
  private Literals() {}

  /** A number. */
  public static final class Number extends Node {
    private final double value;

    public Number(Span span, double value) {
      super(span);
      this.value = value;
    }

    public double value() {
      return value;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      return frame.interpreter.values().number(value);
    }

    @Override
    public boolean test(Frame frame) {
      return value != 0;
    }
  }

  /** A string. */
  public static final class Text extends Node {
    private final String value;

    public Text(Span span, String value) {
      super(span);
      this.value = value;
    }

    public String value() {
      return value;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      return frame.interpreter.values().string(value);
    }
  }

  /** A list, or a tuple. */
  public static final class Sequence extends Node {
    private final Node[] elements;
    private final boolean tuple;

    public Sequence(Span span, Node[] elements, boolean tuple) {
      super(span);
      this.elements = elements;
      this.tuple = tuple;
    }

    public Node[] elements() {
      return elements;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      var list = new Elements(elements.length);
      for (Node element : elements) {
        list.add(ArgumentEvaluation.notVoid(frame, element, span()));
      }
      return of(frame, list);
    }

    /** The list or tuple of elements that have been evaluated. */
    UrbiObject of(Frame frame, Elements list) {
      var values = frame.interpreter.values();
      return tuple ? values.tuple(list) : values.listOf(list);
    }
  }

  /** A dictionary. */
  public static final class Dictionary extends Node {
    private final Node[] keys;
    private final Node[] values;

    public Dictionary(Span span, Node[] keys, Node[] values) {
      super(span);
      this.keys = keys;
      this.values = values;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      Map<UrbiDictionary.Key, UrbiObject> entries = new LinkedHashMap<>();
      for (int i = 0; i < keys.length; i++) {
        entries.put(
            DictionaryKey.of(frame, ArgumentEvaluation.notVoid(frame, keys[i], span())),
            ArgumentEvaluation.notVoid(frame, values[i], span()));
      }
      return frame.interpreter.values().dictionary(entries);
    }
  }

  /** {@code this}. */
  public static final class This extends Node {
    public This(Span span) {
      super(span);
    }

    @Override
    public UrbiObject execute(Frame frame) {
      return frame.self;
    }
  }

  /** A function text: creates a function with the variables that it captures. */
  public static final class Closure extends Node {
    private final Function.Body body;
    private final int[] capturedFrom;
    private final boolean bound;

    /**
     * @param capturedFrom for each captured variable, its cell in the surrounding frame, or -1 - n
     *     for the n-th variable captured by the surrounding function
     * @param bound whether {@code this} is that of the definition
     */
    public Closure(Span span, Function.Body body, int[] capturedFrom, boolean bound) {
      super(span);
      this.body = body;
      this.capturedFrom = capturedFrom;
      this.bound = bound;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      Cell[] captured = new Cell[capturedFrom.length];
      for (int i = 0; i < captured.length; i++) {
        captured[i] = Variables.cell(frame, capturedFrom[i]);
      }
      return new Function(
          frame.interpreter.prototypes.codeShape,
          body,
          captured,
          bound ? frame.self : null,
          bound || !frame.job.isOwner() ? frame.job.lobby() : null,
          body.leavesHome ? home(frame) : null);
    }

    /** The activation of the function around all closures; null at the top level. */
    private static @Nullable Frame home(Frame frame) {
      if (frame.function == null) {
        return null;
      }
      return frame.function.isClosure() ? frame.function.home() : frame.activation;
    }
  }
}
