package org.urbi.ros.graph;

import java.util.concurrent.CompletableFuture;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.message.ActionType;

/** The actions that this node has others pursue, or pursues for others. */
public interface Actions {
  /**
   * What sends goals to an action, as soon as that is there; fails with a {@link RosException} if
   * it is not.
   *
   * @param type null for that of the server
   */
  CompletableFuture<ActionClient> client(String action, @Nullable ActionType type);

  /**
   * Offers an action.
   *
   * @throws RosException if the name is no name of an action, or this node offers it already
   */
  ActionServer serve(String action, ActionType type, ActionServer.Handler handler);
}
