package org.urbi.kernel.remote;

import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import urbi.UValue;

/** A process with UObjects, whatever protocol it uses. Used on the kernel thread. */
public interface RemoteProcess {
  /** Calls a function of one of its objects. */
  CompletionStage<UValue> call(String object, String function, UValue... arguments);

  /** Why the connection is lost; null while it is not. */
  @Nullable String lost();

  /** The urbiscript object has gone. */
  void gone(RemoteObject object);
}
