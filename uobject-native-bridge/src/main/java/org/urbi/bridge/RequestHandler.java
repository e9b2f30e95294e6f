package org.urbi.bridge;

import static java.util.Objects.requireNonNull;

import java.net.InetSocketAddress;
import java.time.Duration;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import urbi.UContext;
import urbi.UEmitter;
import urbi.UObject;
import urbi.UObjectHub;
import urbi.UObjectMode;
import urbi.UProperty;
import urbi.USlot;
import urbi.UValue;
import urbi.spi.ContextEndedException;

/** Executes the requests of C++ code, see {@code urbi/detail/boundary.h}. Any thread may ask. */
final class RequestHandler {
  private static final int OBJECT_NEW = 1;
  private static final int OBJECT_GONE = 2;
  private static final int OBJECT_FIND = 3;
  private static final int HUB_FIND = 4;
  private static final int FUNCTION = 5;
  private static final int EVERY = 6;
  private static final int TIMER_END = 7;
  private static final int VARIABLE = 8;
  private static final int VARIABLE_CLOSE = 9;
  private static final int VARIABLE_GET = 10;
  private static final int VARIABLE_SYNC = 11;
  private static final int VARIABLE_SET = 12;
  private static final int VARIABLE_BYPASS = 13;
  private static final int VARIABLE_TIME = 14;
  private static final int VARIABLE_IN = 15;
  private static final int VARIABLE_OUT = 16;
  private static final int VARIABLE_GET_PROPERTY = 17;
  private static final int VARIABLE_SET_PROPERTY = 18;
  private static final int VARIABLE_OWN = 19;
  private static final int VARIABLE_IS_OWNED = 20;
  private static final int VARIABLE_CHANGE = 21;
  private static final int VARIABLE_ACCESS = 22;
  private static final int VARIABLE_UNNOTIFY = 23;
  private static final int VARIABLE_KEEP = 24;
  private static final int VARIABLE_RTP = 25;
  private static final int EVENT = 26;
  private static final int EVENT_EMIT = 27;
  private static final int EVENT_CLOSE = 28;
  private static final int SEND = 29;
  private static final int CALL = 30;
  private static final int REPORT = 31;
  private static final int THREAD_LIMIT = 32;
  private static final int MODE = 33;
  private static final int CONVERT = 34;
  private static final int CHECK = 35;
  private static final int YIELD = 36;
  private static final int LOCK = 37;
  private static final int UNLOCK = 38;
  private static final int CALLBACK_END = 39;
  private static final int SERVER = 40;

  private static final UProperty[] PROPERTIES = UProperty.values();

  /** What the last request of a thread that has failed has thrown. */
  private static final ThreadLocal<Throwable> FAILURE = new ThreadLocal<>();

  private final NativeContext in;
  private final UContext context;
  private final long subject;
  private final ValueReader arguments;
  private final ValueWriter reply;

  private RequestHandler(NativeContext in, long exchange, ValueWriter reply) {
    this.in = in;
    this.context = in.context();
    this.subject = Exchange.subject(exchange);
    this.arguments = new ValueReader(Exchange.data(exchange), Exchange.length(exchange));
    this.reply = reply;
  }

  /** Carries out the request at an address. No exception may get to the C++ code. */
  static long carryOut(long exchange) {
    long given = Exchange.reply(exchange);
    ValueWriter reply = new ValueWriter(given, Exchange.replyCapacity(exchange));
    long result;
    try {
      result = carryOut(exchange, (int) Exchange.operation(exchange), reply);
    } catch (ContextEndedException e) {
      result = isWriting((int) Exchange.operation(exchange)) ? 0 : failure(e, reply);
    } catch (Throwable e) {
      result = failure(e, reply);
    }
    Exchange.setReply(exchange, reply.address());
    Exchange.setReplyLength(exchange, reply.length());
    return result;
  }

  private static long failure(Throwable e, ValueWriter reply) {
    FAILURE.set(e);
    reply.restart();
    reply.plain(RequestFailure.text(e));
    return Exchange.FAILED;
  }

  /**
   * Whether nobody misses what is asked for when the kernel has ended. Components of 2.7 have
   * threads that write until the process ends, and binaries that hold memory of others until the
   * assignment has returned: an exception would have them free it.
   */
  private static boolean isWriting(int operation) {
    return operation == VARIABLE_SET || operation == EVENT_EMIT;
  }

  /** The failure of a request that C++ code has let pass; null if there is none. */
  static @Nullable RuntimeException passed() {
    Throwable failure = FAILURE.get();
    FAILURE.remove();
    return failure instanceof RuntimeException passed ? passed : null;
  }

  private static long carryOut(long exchange, int operation, ValueWriter reply)
      throws InterruptedException {
    if (operation == CONVERT) {
      var arguments = new ValueReader(Exchange.data(exchange), Exchange.length(exchange));
      reply.value(Conversions.convert(arguments));
      return 0;
    }
    NativeContext in = NativeContext.find(Exchange.context(exchange));
    if (in == null) {
      throw new IllegalStateException("this code belongs to no kernel, or to one that has ended");
    }
    in.module().threads().met(Thread.currentThread());
    return new RequestHandler(in, exchange, reply).carryOutOperation(operation);
  }

  private long carryOutOperation(int operation) throws InterruptedException {
    if (operation >= VARIABLE_CLOSE && operation <= VARIABLE_RTP) {
      return onVariable(operation, variable());
    }
    switch (operation) {
      case OBJECT_NEW -> {
        return newObject(arguments.text());
      }
      case OBJECT_GONE -> resident(subject).deletedByItself();
      case OBJECT_FIND -> {
        UObject found = context.getUObject(arguments.text());
        return found instanceof NativeObject object ? address(object.resident()) : 0;
      }
      case HUB_FIND -> {
        UObjectHub found = context.getUObjectHub(arguments.text());
        return found instanceof NativeHub hub ? address(hub.resident()) : 0;
      }
      case FUNCTION -> bind(resident(subject));
      case EVERY -> {
        return every(resident(subject));
      }
      case TIMER_END -> {
        Runnable end = in.timers.remove(subject);
        if (end == null) {
          return 0;
        }
        end.run();
        return 1;
      }
      case VARIABLE -> {
        String name = arguments.text();
        boolean port = arguments.rawLong() != 0;
        return in.variables.add(
            new NativeVariable(port ? context.inputPort(name) : context.variable(name)));
      }
      case EVENT -> {
        return in.events.add(context.event(arguments.text()));
      }
      case EVENT_EMIT -> event().emit(values());
      case EVENT_CLOSE -> in.events.remove(subject);
      case SEND -> context.send(arguments.text());
      case CALL -> {
        String object = arguments.text();
        context.call(object, arguments.text(), values());
      }
      case REPORT -> context.report(arguments.text());
      case THREAD_LIMIT -> context.setThreadLimit((int) arguments.rawLong());
      case MODE -> {
        return context.getRunningMode() == UObjectMode.MODE_PLUGIN ? 1 : 2;
      }
      case CHECK -> {
        return 0;
      }
      case YIELD -> yieldFor(Duration.of(arguments.rawLong(), ChronoUnit.MICROS));
      case LOCK -> context.lock();
      case UNLOCK -> context.unlock();
      case CALLBACK_END ->
          ((NativeObject) resident(subject).javaSide()).endNotification(arguments.rawLong());
      case SERVER -> {
        return server();
      }
      default -> throw new IllegalStateException("unknown request " + operation);
    }
    return 0;
  }

  /** Waits; a job whose thread has native frames waits with all others. */
  private void yieldFor(Duration time) throws InterruptedException {
    if (Thread.currentThread().isVirtual() || NativeFrames.isHeld()) {
      Thread.sleep(time);
    } else {
      context.yieldFor(time);
    }
  }

  private long server() {
    InetSocketAddress server = context.server();
    if (server == null) {
      return 0;
    }
    reply.text(server.getHostString());
    return server.getPort();
  }

  // ------------------------------------------------------------------ objects

  /** Where the C++ side is; 0 while there is none yet, and when it is gone. */
  private static long address(@Nullable NativeInstance found) {
    return found == null ? 0 : found.address();
  }

  private NativeInstance resident(long number) {
    NativeInstance found = in.residents.find(number);
    if (found == null) {
      throw new IllegalStateException("the object has been destroyed");
    }
    return found;
  }

  private long newObject(String name) {
    UContext before = UContext.enter(context);
    try {
      NativeObject made = NativeObject.adopt(in);
      reply.text(made.get__name());
      return requireNonNull(made.resident(), "it was adopted").number();
    } finally {
      UContext.enter(before);
    }
  }

  private void bind(NativeInstance owner) {
    String name = arguments.text();
    NativeObject object = (NativeObject) owner.javaSide();
    object.bindNative(name, NativeCallback.read(arguments, owner, owner.name() + "." + name, name));
  }

  private long every(NativeInstance owner) {
    double period = arguments.rawDouble();
    boolean after = arguments.rawLong() != 0;
    String name = owner.name() + (after ? ".update" : ".timer");
    return in.timers.add(
        context.every(
            owner.javaSide(), period, NativeCallback.read(arguments, owner, name, name), after));
  }

  private UEmitter event() {
    UEmitter found = in.events.find(subject);
    if (found == null) {
      throw new IllegalStateException("invalid use of unbound UEvent");
    }
    return found;
  }

  private UValue[] values() {
    List<UValue> values = new ArrayList<>();
    while (!arguments.ended()) {
      values.add(arguments.value());
    }
    return values.toArray(UValue[]::new);
  }

  // ------------------------------------------------------------------ variables

  private NativeVariable variable() {
    NativeVariable found = in.variables.find(subject);
    if (found == null) {
      throw new IllegalStateException("invalid use of unbound UVar");
    }
    return found;
  }

  private long onVariable(int operation, NativeVariable variable) {
    USlot slot = variable.slot();
    switch (operation) {
      case VARIABLE_GET -> reply.value(slot.get());
      case VARIABLE_SET -> variable.set(arguments);
      case VARIABLE_SYNC -> reply.value(slot.sync());
      case VARIABLE_CLOSE -> {
        in.variables.remove(subject);
        slot.close();
      }
      case VARIABLE_BYPASS -> {
        return variable.setBypass(arguments.rawLong() != 0) ? 1 : 0;
      }
      case VARIABLE_TIME -> {
        return slot.timestamp();
      }
      case VARIABLE_IN -> reply.rawDouble(slot.in());
      case VARIABLE_OUT -> reply.rawDouble(slot.out());
      case VARIABLE_GET_PROPERTY -> reply.value(slot.property(property()));
      case VARIABLE_SET_PROPERTY -> {
        UProperty property = property();
        slot.setProperty(property, arguments.value());
      }
      case VARIABLE_OWN -> slot.own();
      case VARIABLE_IS_OWNED -> {
        return slot.isOwned() ? 1 : 0;
      }
      case VARIABLE_CHANGE, VARIABLE_ACCESS -> notify(operation == VARIABLE_CHANGE, slot);
      case VARIABLE_UNNOTIFY -> slot.unnotify();
      case VARIABLE_KEEP -> slot.keepSynchronized();
      case VARIABLE_RTP -> slot.useRtp(arguments.rawLong() != 0);
      default -> throw new IllegalStateException("unknown request " + operation);
    }
    return 0;
  }

  private UProperty property() {
    return PROPERTIES[(int) arguments.rawLong()];
  }

  private void notify(boolean change, USlot slot) {
    NativeInstance owner = resident(arguments.rawLong());
    NativeObject object = (NativeObject) owner.javaSide();
    String name = owner.name() + (change ? ".onChange(" : ".onAccess(") + slot.name() + ")";
    long address = arguments.peekLong();
    var callback = NativeCallback.read(arguments, owner, name, slot.name());
    Runnable end = change ? slot.onChange(object, callback) : slot.onAccess(object, callback);
    object.endLater(address, end);
  }
}
