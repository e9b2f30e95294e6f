package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * {@code target.slot'n}: the value of a slot on the scale from 0, its {@code rangemin}, to 1, its
 * {@code rangemax}. If the slot has no range, it is the message {@code 'n} to its value.
 */
public final class Normalized extends Node {
  private final Node target;
  private final Symbol slot;
  private final Node plain;
  private final @Nullable Node value;

  /**
   * @param plain the node to execute for a slot without a range
   * @param value the assigned value, or null
   */
  public Normalized(Span span, Node target, Symbol slot, Node plain, @Nullable Node value) {
    super(span);
    this.target = target;
    this.slot = slot;
    this.plain = plain;
    this.value = value;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    try {
      UrbiObject object = target.execute(frame);
      if (bound(frame, object, "rangemin") instanceof UrbiFloat least
          && bound(frame, object, "rangemax") instanceof UrbiFloat most) {
        return value == null
            ? read(frame, object, least.value(), most.value())
            : write(frame, object, value, least.value(), most.value());
      }
    } catch (UrbiException e) {
      throw frame.located(e, span());
    }
    return plain.execute(frame);
  }

  private @Nullable UrbiObject bound(Frame frame, UrbiObject object, String property) {
    return object.locate(slot) == null ? null : Properties.find(frame, object, slot, property);
  }

  private UrbiObject read(Frame frame, UrbiObject object, double least, double most) {
    UrbiObject current = frame.interpreter.send(frame, object, slot.name());
    return frame.interpreter.values().number((number(frame, current) - least) / (most - least));
  }

  private UrbiObject write(
      Frame frame, UrbiObject object, Node assigned, double least, double most) {
    UrbiObject part = ArgumentEvaluation.notVoid(frame, assigned, span());
    double scaled = least + number(frame, part) * (most - least);
    SlotUpdate.assign(frame, object, slot, frame.interpreter.values().number(scaled));
    return part;
  }

  private static double number(Frame frame, UrbiObject given) {
    if (given instanceof UrbiFloat number) {
      return number.value();
    }
    throw frame.interpreter.errors().type(given, frame.interpreter.values().floatProto);
  }
}
