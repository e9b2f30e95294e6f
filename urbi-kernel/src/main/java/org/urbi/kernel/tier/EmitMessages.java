package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_boolean;
import static java.lang.constant.ConstantDescs.CD_double;
import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_void;

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
import org.urbi.kernel.tier.Callees.Callee;

/** Emits messages. A function that was found until now is called at once, if it is compiled. */
final class EmitMessages {
  private final Emitter to;
  private final EmitSlots slots;
  private final EmitContainers containers;
  private final Callees callees;
  private final Unit unit;

  EmitMessages(Emitter to, EmitSlots slots, EmitContainers containers, Callees callees, Unit unit) {
    this.to = to;
    this.slots = slots;
    this.containers = containers;
    this.callees = callees;
    this.unit = unit;
  }

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

  // ------------------------------------------------------------------ without arguments

  private void ask(MessageSend message, int receiver, Value result) {
    Label answers = to.code.newLabel();
    Label over = to.code.newLabel();
    int found = result.object();
    List<KnownSlot> places = slots.places(message.lookup(), message.target());
    boolean hasCode = false;
    for (KnownSlot place : places) {
      UrbiCode code = place.code();
      if (place.own() != null) {
        Label next = to.code.newLabel();
        slots.readOwn(place, receiver, found, next);
        callOwn(place, message, receiver, found, List.of(), result, over);
        to.code.goto_(answers).labelBinding(next);
        hasCode = true;
        continue;
      }
      if (code == null) {
        slots.plainValue(place, receiver, found, over);
        continue;
      }
      Label next = to.code.newLabel();
      slots.check(place, receiver, next);
      Callee callee = callees.of(code, 0);
      Shortcut shortcut = callees.shortcut(code, 0);
      if (shortcut != null) {
        containers.take(shortcut, receiver, List.of(), result, next);
        to.code.goto_(over);
      } else if (callee != null) {
        unlessOutdated(callee, code, next);
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
      to.scopes().enter();
      answer(message, receiver, found);
    } else {
      to.scopes().enter();
      ask(message, receiver);
    }
    to.code.astore(found);
    to.afterOthers();
    to.code.labelBinding(over);
  }

  /** Calls what has been found in a slot of the target itself, if it is the expected function. */
  private void callOwn(
      KnownSlot place,
      MessageSend message,
      int receiver,
      int found,
      List<Value> arguments,
      Value result,
      Label over) {
    Function.Body body = place.own() == null ? null : place.own().body();
    Callee callee = callees.of(body, arguments.size());
    if (callee != null) {
      Label other = to.code.newLabel();
      unlessCallable(found, callee, other);
      call(callee, () -> function(found), message, receiver, arguments, result);
      to.code.goto_(over).labelBinding(other);
    }
  }

  /** Jumps unless what has been found is that function, and its code can be called. */
  private void unlessCallable(int found, Callee callee, Label otherwise) {
    to.code.aload(found);
    to.constant(callee.body(), Names.BODY);
    to.help("isFunction", CD_boolean, Names.OBJECT, Names.BODY);
    to.code.ifeq(otherwise);
    unlessOutdated(callee, otherwise);
  }

  private void function(int found) {
    to.code.aload(found).checkcast(Names.FUNCTION);
  }

  private void countMiss(List<KnownSlot> places) {
    if (!places.isEmpty()) {
      slots.missed();
    }
  }

  /** Sends the message, with all that belongs to it. */
  private void ask(MessageSend message, int receiver) {
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
    Callee callee = callees.of(code, count);
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
    unlessOutdated(callee, code, other);
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
    Map<UrbiCode, Callee> functions = new LinkedHashMap<>();
    Map<UrbiCode, Shortcut> shortcuts = new LinkedHashMap<>();
    to.code.aconst_null().astore(known);
    for (KnownSlot place : places) {
      Label next = to.code.newLabel();
      slots.check(place, receiver, next);
      slots.read(place, receiver);
      to.code.astore(found);
      UrbiCode code = place.code();
      Callee callee = callees.of(code, count);
      Shortcut shortcut = callees.shortcut(code, count);
      if (code != null && callee != null) {
        functions.put(code, callee);
      }
      if (code != null && shortcut != null) {
        shortcuts.put(code, shortcut);
      }
      if (code != null && callee != null) {
        Label outdated = to.code.newLabel();
        unlessOutdated(callee, code, outdated);
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
    functions.forEach((code, callee) ->
        when(
            known,
            code,
            next -> call(callee, () -> function(code), message, receiver, arguments, result),
            over));
    for (KnownSlot place : places) {
      callOwn(place, message, receiver, found, arguments, result, over);
    }
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
    Callee callee = callees.of(message.called(), count);
    if (callee != null) {
      Label other = to.code.newLabel();
      to.doubt(other);
      unlessCallable(found, callee, other);
      call(callee, () -> function(found), message, receiver, arguments(message), result);
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

  /**
   * Jumps if other code of the function would be faster, or if it is not the one that is running
   * but another of the same text.
   */
  private void unlessOutdated(Callee callee, UrbiCode code, Label otherwise) {
    Activation.OfItself own = own(callee);
    if (own == null) {
      unlessOutdated(callee, otherwise);
      return;
    }
    own.calls(to.code);
    function(code);
    to.help("isOwn", CD_boolean, Names.OWN_CALLS, Names.FUNCTION);
    to.code.ifeq(otherwise);
  }

  private void unlessOutdated(Callee callee, Label otherwise) {
    if (callee.compiled() != null) {
      to.constant(callee.compiled().misses(), Names.MISSES);
      to.code.invokevirtual(Names.MISSES, "isOver", MethodTypeDesc.of(CD_boolean)).ifne(otherwise);
    }
  }

  /** How the function calls itself without a frame; null if it does not, or another is called. */
  private Activation.@Nullable OfItself own(Callee callee) {
    return callee.compiled() == null && to.activation instanceof Activation.OfItself own
        ? own
        : null;
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
    Activation.OfItself own = own(callee);
    if (own == null) {
      callOther(callee, function, message, receiver, arguments, result);
    } else {
      callItself(own, message, arguments, result);
    }
    to.afterOthers();
  }

  private void callOther(
      Callee callee,
      Runnable function,
      CallSite message,
      int receiver,
      List<Value> arguments,
      Value result) {
    MethodTypeDesc type = EmitFunction.callType(arguments.size());
    if (callee.compiled() != null) {
      to.constant(callee.compiled(), Names.COMPILED_CODE);
    }
    function.run();
    to.frame();
    to.constant(message, Names.SITE);
    to.code.aload(receiver);
    arguments.forEach(this::pass);
    if (callee.compiled() == null) {
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
  }

  /** Calls the function that is running, for the same target. */
  private void callItself(
      Activation.OfItself own, CallSite message, List<Value> arguments, Value result) {
    own.place(to.code);
    to.code.loadConstant(own.number(message));
    to.constant(unit.frame().interpreter(), Names.INTERPRETER);
    to.help("enter", CD_void, Names.OWN_CALLS, CD_int, CD_int, Names.INTERPRETER);
    own.place(to.code);
    to.code.iconst_1().iadd();
    arguments.forEach(this::pass);
    to.code.invokestatic(
        unit.owner(), EmitFunction.BODY, EmitFunction.bodyType(own, arguments.size()));
    Label number = to.code.newLabel();
    to.code.dstore(result.number()).aconst_null().astore(result.object());
    slots.unlessMissing(result.number(), number);
    own.calls(to.code);
    to.help("answered", Names.OBJECT, Names.OWN_CALLS);
    to.code.astore(result.object()).labelBinding(number);
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
