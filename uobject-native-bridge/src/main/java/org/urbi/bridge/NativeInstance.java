package org.urbi.bridge;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import urbi.LockMode;
import urbi.UContext;
import urbi.UTaskQueue;

/**
 * The C++ side of an object or a hub: its address and its reference count. It is deleted when its
 * Java side has ended and the last call has returned.
 */
final class NativeInstance {
  private static final long OBJECT = 0;
  private static final long HUB = 1;

  private final NativeContext in;
  private final long kind;
  private final String className;
  private final String name;
  private final Object javaSide;
  private final long number;
  private final UTaskQueue queue = new UTaskQueue();
  private final Map<String, UTaskQueue> functionQueues = new ConcurrentHashMap<>();

  /** The Java side until it ends, and each call. */
  private final AtomicInteger users = new AtomicInteger(1);

  private volatile long address;

  private NativeInstance(
      NativeContext in, long kind, String className, String name, Object javaSide) {
    this.in = in;
    this.kind = kind;
    this.className = className;
    this.name = name;
    this.javaSide = javaSide;
    this.number = in.residents.add(this);
    in.module().retain();
  }

  /** Constructs the C++ side of an object. */
  static NativeInstance ofObject(NativeContext in, String className, NativeObject object) {
    var made = new NativeInstance(in, OBJECT, className, object.get__name(), object);
    made.construct();
    return made;
  }

  /** Constructs the C++ side of a hub. */
  static NativeInstance ofHub(NativeContext in, NativeHub hub) {
    var made = new NativeInstance(in, HUB, hub.get_name(), hub.get_name(), hub);
    made.construct();
    return made;
  }

  /** An object that C++ code has made by itself, and will delete itself. */
  static NativeInstance adopted(NativeContext in, NativeObject object) {
    return new NativeInstance(in, OBJECT, object.getClassname(), object.get__name(), object);
  }

  private void construct() {
    try {
      address = in.execute(this::create);
    } catch (RuntimeException e) {
      end();
      throw e;
    }
  }

  private long create() {
    ModuleFunctions entries = in.module().entries();
    CallFrame frame = CallFrame.take();
    try {
      frame.arguments.text(className);
      frame.arguments.text(name);
      frame.prepare(kind, in.number(), number);
      long made = entries.create(frame.exchange);
      if (made == Exchange.FAILED) {
        throw frame.failure();
      }
      return made;
    } finally {
      frame.release(entries);
    }
  }

  NativeContext in() {
    return in;
  }

  String name() {
    return name;
  }

  long number() {
    return number;
  }

  /** The UObject or UObjectHub; 0 while it is constructed, and for an adopted one. */
  long address() {
    return address;
  }

  /** The {@link NativeObject} or {@link NativeHub}. */
  Object javaSide() {
    return javaSide;
  }

  /** The calls that a threaded one excludes; null for none. */
  @Nullable UTaskQueue queue(LockMode mode, String what) {
    return switch (mode) {
      case LOCK_NONE -> null;
      case LOCK_FUNCTION -> functionQueues.computeIfAbsent(what, key -> new UTaskQueue());
      case LOCK_INSTANCE -> queue;
      case LOCK_CLASS -> in.module().classQueue(className);
      case LOCK_MODULE -> in.module().queue();
    };
  }

  /** A call begins: the object stays until it ends. False if it has gone already. */
  boolean enter() {
    for (; ; ) {
      int present = users.get();
      if (present == 0) {
        return false;
      }
      if (users.compareAndSet(present, present + 1)) {
        return true;
      }
    }
  }

  /** A call has ended. */
  void leave() {
    if (users.decrementAndGet() == 0) {
      delete();
    }
  }

  /** C++ code has deleted it. */
  void deletedByItself() {
    address = 0;
    if (javaSide instanceof NativeObject object) {
      object.clean();
    }
  }

  /** The Java side has ended. */
  void end() {
    leave();
  }

  private void delete() {
    if (address != 0) {
      address = in.execute(this::destroy);
    }
    in.residents.remove(number);
    in.module().release();
  }

  /** Deletes it; returns where it is then. */
  private long destroy() {
    ModuleFunctions entries = in.module().entries();
    CallFrame frame = CallFrame.take();
    UContext before = UContext.enter(in.context());
    try {
      frame.prepare(kind, in.number(), address);
      if (entries.destroy(frame.exchange) == Exchange.FAILED) {
        in.context().report("exception caught while deleting " + name + ": " + frame.error());
      }
      return 0;
    } finally {
      UContext.enter(before);
      frame.release(entries);
    }
  }
}
