package urbi.remote;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import urbi.spi.ComponentFailureLog;

/** Tells listeners what the server shows: each of them, whatever another one throws. */
final class OutputListeners {
  private final ComponentFailureLog failureLog;
  private final List<Consumer<byte[]>> listeners = new CopyOnWriteArrayList<>();

  OutputListeners(ComponentFailureLog failureLog) {
    this.failureLog = failureLog;
  }

  void add(Consumer<byte[]> listener) {
    listeners.add(listener);
  }

  void tell(byte[] text) {
    for (Consumer<byte[]> listener : listeners) {
      try {
        listener.accept(text);
      } catch (RuntimeException | Error e) {
        failureLog.log("a listener to what the server shows", e);
      }
    }
  }
}
