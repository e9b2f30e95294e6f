package org.urbi.bridge;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import urbi.UCallback;
import urbi.UObject;

/** The Java side of a UObject that is written in C++. */
final class NativeObject extends UObject implements AutoCloseable {
  /** What ends notifications, by the addresses of their callbacks. */
  private final Map<Long, Runnable> notifications = new ConcurrentHashMap<>();

  private @Nullable NativeInstance resident;
  private boolean ended;

  private NativeObject(String name) {
    super(name);
  }

  private NativeObject() {}

  /** Makes one with its C++ side. */
  static NativeObject create(NativeModule module, String className, String name) {
    NativeObject made = new NativeObject(name);
    try {
      made.resident = NativeInstance.ofObject(module.in(made.getUContext()), className, made);
    } catch (RuntimeException e) {
      made.clean();
      throw e;
    }
    return made;
  }

  /** Makes one for an object that C++ code has made by itself. */
  static NativeObject adopt(NativeContext in) {
    NativeObject made = new NativeObject();
    made.resident = NativeInstance.adopted(in, made);
    return made;
  }

  /** Its C++ side; null while that is being made. */
  @Nullable NativeInstance resident() {
    return resident;
  }

  /** A notification ends with the object. */
  void endLater(long callback, Runnable notification) {
    notifications.put(callback, notification);
  }

  /** A notification ends now. */
  void endNotification(long callback) {
    Runnable end = notifications.remove(callback);
    if (end != null) {
      end.run();
    }
  }

  void bindNative(String urbiName, UCallback function) {
    bind(urbiName, function);
  }

  /** The urbiscript object has gone: the C++ object is deleted. */
  @Override
  public void close() {
    NativeInstance present = resident;
    synchronized (this) {
      if (ended || present == null) {
        return;
      }
      ended = true;
    }
    notifications.values().forEach(Runnable::run);
    present.end();
  }
}
