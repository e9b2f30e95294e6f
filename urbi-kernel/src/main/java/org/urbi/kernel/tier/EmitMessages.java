package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_boolean;
import static java.lang.constant.ConstantDescs.CD_double;
import static java.lang.constant.ConstantDescs.CD_int;

import java.lang.classfile.Label;
import java.lang.constant.MethodTypeDesc;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.CompiledCode;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.node.KnownSlot;
import org.urbi.kernel.node.MessageSend;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Shortcut;
import org.urbi.kernel.object.UrbiCode;

/** Emits messages. A function that was found until now is called at once, if it is compiled. */
final class EmitMessages {
  private final Emitter to;
  private final EmitSlots slots;
  private final EmitContainers containers;
  private final Unit unit;

  EmitMessages(Emitter to, EmitSlots slots, EmitContainers containers, Unit unit) {
    this.to = to;
    this.slots = slots;
    this.containers = containers;
    this.unit = unit;
  }

  /**
   * A function that is called at once.
   *
   * @param body what it shares with other closures of the same text
   * @param compiled its code; null if that is what is being compiled
   */
  private record Callee(Function.Body body, @Nullable CompiledCode compiled) {}

  Value value(MessageSend message) {
    int receiver = to.newObject();
    Node target = message.target();
    if (target == null) {
      to.self();
    } else {
      to.load(to.operand(target));
    }
    to.code.astore(receiver);
    Value result = to.newPair();
    to.located(
        message,
        () -> {
          if (message.argumentNodes().length == 0) {
            ask(message, receiver, result);
          } else {
            send(message, receiver, result);
          }
        });
    return result;
  }

  private @Nullable Callee callee(@Nullable UrbiCode code, int arguments) {
    return code instanceof Function function && function.isUnbound()
        ? callee(function.body(), arguments)
        : null;
  }

  private @Nullable Callee callee(Function.@Nullable Body body, int arguments) {
    if (body == null
        || arguments > EmitFunction.MOST_PARAMETERS
        || unit.frame().interpreter().isProfiling()) {
      return null;
    }
    if (body == unit.function()) {
      return body.takesPlainly(arguments) ? new Callee(body, null) : null;
    }
    CompiledCode compiled = body.direct(unit.frame(), arguments);
    return compiled == null ? null : new Callee(body, compiled);
  }

  /**
   * Whether a message has only read slots and containers until now, as far as is known: what calls
   * somebody all the same gives back before, and is only slower.
   */
  boolean callsNobody(MessageSend message) {
    List<KnownSlot> places = slots.places(message.lookup(), message.target());
    int count = message.argumentNodes().length;
    return !places.isEmpty()
        && places.stream()
            .map(KnownSlot::code)
            .allMatch(code -> code == null || containers.shortcut(code, count) != null);
  }

  // ------------------------------------------------------------------ without arguments

  private void ask(MessageSend message, int receiver, Value result) {
    Label answers = to.code.newLabel();
    Label over = to.code.newLabel();
    int found = result.object();
    List<KnownSlot> places = slots.places(message.lookup(), message.target());
    boolean hasCode = false;
    for (KnownSlot place : places) {
      UrbiCode code = place.code();
      if (code == null) {
        slots.plainValue(place, receiver, found, over);
        continue;
      }
      Label next = to.code.newLabel();
      slots.check(place, receiver, next);
      Callee callee = callee(code, 0);
      Shortcut shortcut = containers.shortcut(code, 0);
      if (shortcut != null) {
        containers.take(shortcut, receiver, List.of(), result, next);
        to.code.goto_(over);
      } else if (callee != null) {
        unlessOutdated(callee, next);
        call(callee, () -> function(code), message, receiver, List.of(), result);
        to.code.goto_(over);
      } else {
        slots.read(place, receiver);
        to.code.astore(found).goto_(answers);
        hasCode = true;
      }
      to.code.labelBinding(next);
    }
    countMiss(places);
    if (hasCode) {
      find(message, receiver, found);
      to.code.labelBinding(answers);
      answer(message, receiver, found);
    } else {
      ask(message, receiver);
    }
    to.code.astore(found);
    to.afterOthers();
    to.code.labelBinding(over);
  }

  private void countMiss(List<KnownSlot> places) {
    if (!places.isEmpty()) {
      slots.missed();
    }
  }

  /** Sends the message, with all that belongs to it. */
  private void ask(MessageSend message, int receiver) {
    to.scopes().enter();
    to.code.aload(receiver);
    to.frame();
    to.constant(message, Names.MESSAGE);
    to.help("send", Names.OBJECT, Names.OBJECT, Names.FRAME, Names.MESSAGE);
  }

  private void find(MessageSend message, int receiver, int found) {
    to.scopes().enter();
    to.code.aload(receiver);
    to.frame();
    to.constant(message, Names.MESSAGE);
    to.help("find", Names.OBJECT, Names.OBJECT, Names.FRAME, Names.MESSAGE);
    to.code.astore(found);
  }

  private void answer(MessageSend message, int receiver, int found) {
    to.scopes().enter();
    to.code.aload(found).aload(receiver);
    to.frame();
    to.constant(message, Names.MESSAGE);
    to.help("answer", Names.OBJECT, Names.OBJECT, Names.OBJECT, Names.FRAME, Names.MESSAGE);
  }

  // ------------------------------------------------------------------ with arguments

  private void send(MessageSend message, int receiver, Value result) {
    List<KnownSlot> places = slots.places(message.lookup(), message.target());
    int count = message.argumentNodes().length;
    UrbiCode code = places.size() == 1 ? places.getFirst().code() : null;
    Callee callee = callee(code, count);
    if (code == null || callee == null) {
      sendToAny(message, receiver, places, result);
    } else {
      send(message, receiver, places.getFirst(), code, callee, result);
    }
  }

  /** Sends a message that has been answered by one function only. */
  private void send(
      MessageSend message,
      int receiver,
      KnownSlot place,
      UrbiCode code,
      Callee callee,
      Value result) {
    Label other = to.code.newLabel();
    Label over = to.code.newLabel();
    slots.check(place, receiver, other);
    unlessOutdated(callee, other);
    call(callee, () -> function(code), message, receiver, arguments(message), result);
    to.code.goto_(over);
    to.code.labelBinding(other);
    slots.missed();
    Value answer = to.beside(message, () -> ask(message, receiver));
    to.code.aload(answer.object()).astore(result.object());
    to.afterOthers();
    to.code.labelBinding(over);
  }

  private void sendToAny(MessageSend message, int receiver, List<KnownSlot> places, Value result) {
    int count = message.argumentNodes().length;
    int found = to.newObject();
    int known = to.newObject();
    Label asked = to.code.newLabel();
    Label ready = to.code.newLabel();
    Label lazy = to.code.newLabel();
    Label over = to.code.newLabel();
    Map<UrbiCode, Callee> callees = new LinkedHashMap<>();
    Map<UrbiCode, Shortcut> shortcuts = new LinkedHashMap<>();
    to.code.aconst_null().astore(known);
    for (KnownSlot place : places) {
      Label next = to.code.newLabel();
      slots.check(place, receiver, next);
      slots.read(place, receiver);
      to.code.astore(found);
      UrbiCode code = place.code();
      Callee callee = callee(code, count);
      Shortcut shortcut = containers.shortcut(code, count);
      if (code != null && callee != null) {
        callees.put(code, callee);
      }
      if (code != null && shortcut != null) {
        shortcuts.put(code, shortcut);
      }
      if (callee != null) {
        Label outdated = to.code.newLabel();
        unlessOutdated(callee, outdated);
        to.code.aload(found).astore(known).labelBinding(outdated);
      } else if (shortcut != null) {
        to.code.aload(found).astore(known);
      }
      to.code.goto_(code != null && CompiledCode.takes(code, count) ? ready : asked);
      to.code.labelBinding(next);
    }
    countMiss(places);
    find(message, receiver, found);
    to.code.labelBinding(asked);
    to.code.aload(found).loadConstant(count);
    to.help("takes", CD_boolean, Names.OBJECT, CD_int);
    to.code.ifeq(lazy);
    to.code.labelBinding(ready);
    List<Value> arguments = arguments(message);
    shortcuts.forEach((code, shortcut) ->
        when(
            known,
            code,
            next -> containers.take(shortcut, receiver, arguments, result, next),
            over));
    callees.forEach((code, callee) ->
        when(
            known,
            code,
            next -> call(callee, () -> function(code), message, receiver, arguments, result),
            over));
    call(message, receiver, found, arguments);
    to.code.astore(result.object());
    to.afterOthers();
    to.code.goto_(over);
    to.code.labelBinding(lazy);
    Value answer = to.beside(message, () -> answer(message, receiver, found));
    to.code.aload(answer.object()).astore(result.object());
    to.afterOthers();
    to.code.labelBinding(over);
  }

  /** Emits what is done when that code has been found; it may jump to do something else. */
  private void when(int known, UrbiCode code, Consumer<Label> done, Label over) {
    Label next = to.code.newLabel();
    to.code.aload(known);
    to.constant(code, Names.OBJECT);
    to.code.if_acmpne(next);
    done.accept(next);
    to.code.goto_(over);
    to.code.labelBinding(next);
  }

  /** A variable of the surrounding code, called as a function. */
  Value value(MessageSend.OfLocal message) {
    Value result = to.newPair();
    to.located(message, () -> send(message, result));
    return result;
  }

  private void send(MessageSend.OfLocal message, Value result) {
    int count = message.argumentNodes().length;
    int found = to.newObject();
    int receiver = to.newObject();
    Label over = to.code.newLabel();
    to.load(to.operand(message.variable()));
    to.code.astore(found);
    to.self();
    to.code.astore(receiver);
    Callee callee = callee(message.called(), count);
    if (callee != null) {
      Label other = to.code.newLabel();
      to.doubt(other);
      to.code.aload(found);
      to.constant(callee.body, Names.BODY);
      to.help("isFunction", CD_boolean, Names.OBJECT, Names.BODY);
      to.code.ifeq(other);
      unlessOutdated(callee, other);
      Runnable function = () -> to.code.aload(found).checkcast(Names.FUNCTION);
      call(callee, function, message, receiver, arguments(message), result);
      to.code.goto_(over);
      to.code.labelBinding(other);
      slots.missed();
    }
    if (count > 0) {
      Label lazy = to.code.newLabel();
      to.code.aload(found).loadConstant(count);
      to.help("takes", CD_boolean, Names.OBJECT, CD_int);
      to.code.ifeq(lazy);
      call(message, receiver, found, arguments(message));
      to.code.astore(result.object());
      to.afterOthers();
      to.code.goto_(over);
      to.code.labelBinding(lazy);
    }
    Value answer = to.beside(message, () -> answer(message, found));
    to.code.aload(answer.object()).astore(result.object());
    to.afterOthers();
    to.code.labelBinding(over);
  }

  private void answer(MessageSend.OfLocal message, int found) {
    to.scopes().enter();
    to.code.aload(found);
    to.frame();
    to.constant(message, Names.LOCAL_CALL);
    to.help("answer", Names.OBJECT, Names.OBJECT, Names.FRAME, Names.LOCAL_CALL);
  }

  /** The arguments, which are kept as they are when they are evaluated. */
  private List<Value> arguments(CallSite message) {
    Node[] nodes = message.argumentNodes();
    List<Value> arguments = new ArrayList<>();
    for (int i = 0; i < nodes.length; i++) {
      Value argument = to.operand(nodes[i]);
      to.notVoid(argument);
      for (int j = i + 1; j < nodes.length; j++) {
        argument = to.kept(argument, nodes[j]);
      }
      arguments.add(argument);
    }
    return arguments;
  }

  /** Calls code that is known only now. */
  private void call(Node message, int receiver, int found, List<Value> arguments) {
    int room = to.newObject();
    to.code.aload(found).loadConstant(arguments.size());
    to.help("room", Names.OBJECTS, Names.OBJECT, CD_int);
    to.code.astore(room);
    for (int i = 0; i < arguments.size(); i++) {
      to.code.aload(room).loadConstant(i);
      to.load(arguments.get(i));
      to.code.aastore();
    }
    to.scopes().enter();
    to.code.aload(found).aload(receiver).aload(room).loadConstant(arguments.size());
    to.frame();
    to.constant(message, Names.SITE);
    to.help(
        "call",
        Names.OBJECT,
        Names.OBJECT,
        Names.OBJECT,
        Names.OBJECTS,
        CD_int,
        Names.FRAME,
        Names.SITE);
  }

  /** Jumps if other code of the function would be faster. */
  private void unlessOutdated(Callee callee, Label otherwise) {
    if (callee.compiled != null) {
      to.constant(callee.compiled.misses(), Names.MISSES);
      to.code.invokevirtual(Names.MISSES, "isOver", MethodTypeDesc.of(CD_boolean)).ifne(otherwise);
    }
  }

  private void function(UrbiCode code) {
    to.constant(code, Names.FUNCTION);
  }

  /** Calls a function whose code is known, and which is pushed by something. */
  private void call(
      Callee callee,
      Runnable function,
      CallSite message,
      int receiver,
      List<Value> arguments,
      Value result) {
    to.beforeOthers();
    MethodTypeDesc type = EmitFunction.callType(arguments.size());
    if (callee.compiled != null) {
      to.constant(callee.compiled, Names.COMPILED_CODE);
    }
    function.run();
    to.frame();
    to.constant(message, Names.SITE);
    to.code.aload(receiver);
    arguments.forEach(this::pass);
    if (callee.compiled == null) {
      to.code.invokestatic(unit.owner(), EmitFunction.DIRECT, type);
    } else {
      to.code.invokevirtual(Names.COMPILED_CODE, EmitFunction.CALL, type);
    }
    Label object = to.code.newLabel();
    to.code.dup().astore(result.object()).ifnonnull(object);
    to.frameIfAny();
    to.help("answer", CD_double, Names.FRAME);
    to.code.dstore(result.number());
    to.code.labelBinding(object);
    to.afterOthers();
  }

  /** Pushes a pair. Of a variable there are two from now on, which must be the same object. */
  private void pass(Value argument) {
    if (argument.hasNumber()) {
      to.code.dload(argument.number());
    } else {
      to.code.dconst_0();
    }
    if (argument.isVariable() || !argument.hasNumber()) {
      to.load(argument);
    } else if (argument.hasObject()) {
      to.code.aload(argument.object());
    } else {
      to.code.aconst_null();
    }
  }
}
