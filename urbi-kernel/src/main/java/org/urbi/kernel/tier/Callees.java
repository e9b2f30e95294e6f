package org.urbi.kernel.tier;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CompiledCode;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.node.KnownSlot;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.MessageSend;
import org.urbi.kernel.node.Shortcut;
import org.urbi.kernel.object.UrbiCode;

/** What the messages of a piece of code have called until now. */
final class Callees {
  /**
   * A function that is called at once.
   *
   * @param body what it shares with other closures of the same text
   * @param compiled its code; null if that is what is being compiled
   */
  record Callee(Function.Body body, @Nullable CompiledCode compiled) {}

  private final Unit unit;
  private final KnownPlaces places;

  Callees(Unit unit) {
    this.unit = unit;
    this.places = new KnownPlaces(unit);
  }

  /** Code that has been found, if it is called at once. */
  @Nullable Callee of(@Nullable UrbiCode code, int arguments) {
    return code instanceof Function function && function.isUnbound()
        ? of(function.body(), arguments)
        : null;
  }

  @Nullable Callee of(Function.@Nullable Body body, int arguments) {
    if (body == null || arguments > EmitFunction.MOST_PARAMETERS || isProfiling()) {
      return null;
    }
    if (body == unit.function()) {
      return body.takesPlainly(arguments) ? new Callee(body, null) : null;
    }
    CompiledCode compiled = body.direct(unit.frame(), arguments);
    return compiled == null ? null : new Callee(body, compiled);
  }

  private boolean isProfiling() {
    return unit.frame().interpreter().isProfiling();
  }

  /** The shortcut for a function that has been found, with that many arguments; null if none. */
  @Nullable Shortcut shortcut(@Nullable UrbiCode code, int arguments) {
    Shortcut known =
        code == null || isProfiling() ? null : unit.frame().interpreter().shortcut(code);
    if (known == null) {
      return null;
    }
    int wanted =
        switch (known) {
          case SIZE_OF_LIST, SIZE_OF_TEXT, SIZE_OF_DICTIONARY, NOT -> 0;
          case ELEMENT, APPEND, ENTRY, HAS_ENTRY -> 1;
          case SET_ELEMENT, SET_ENTRY -> 2;
        };
    return wanted == arguments ? known : null;
  }

  /**
   * Whether a message has only read slots and containers until now, as far as is known: what calls
   * somebody all the same gives back before, and is only slower.
   */
  boolean callsNobody(MessageSend message) {
    List<KnownSlot> known = places.of(message.lookup(), message.target());
    return !known.isEmpty() && callsNobody(message, known);
  }

  private boolean callsNobody(MessageSend message, List<KnownSlot> known) {
    int count = message.argumentNodes().length;
    return known.stream()
        .allMatch(place ->
            place.own() == null && (place.code() == null || shortcut(place.code(), count) != null));
  }

  /** Whether the function has called itself, for the same target, and nobody else. */
  boolean areOnlyTheFunction() {
    List<MessageSend> messages = unit.survey().messages();
    return !unit.survey().mayCallUnseen()
        && messages.stream().anyMatch(this::callsTheFunction)
        && messages.stream()
            .allMatch(message ->
                callsTheFunction(message)
                    || callsNobody(message, places.of(message.lookup(), message.target())));
  }

  private boolean callsTheFunction(MessageSend message) {
    int count = message.argumentNodes().length;
    List<KnownSlot> known = places.of(message.lookup(), message.target());
    return (message.target() == null || message.target() instanceof Literals.This)
        && !known.isEmpty()
        && known.stream()
            .allMatch(place ->
                place.code() instanceof Function function
                    && function.body() == unit.function()
                    && of(function, count) != null);
  }
}
