package org.urbi.ros.graph;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import urbi.UValue;

/** The parameters that are kept in one place for all nodes. */
public interface ParameterServer {
  /** The value of a parameter; fails if there is none. */
  CompletableFuture<UValue> get(String name);

  /**
   * Sets a parameter.
   *
   * @throws RosException if it is nothing that a parameter can be
   */
  CompletableFuture<Void> set(String name, UValue value);

  /** Whether there is a parameter. */
  CompletableFuture<Boolean> has(String name);

  /** Deletes a parameter; fails if there is none. */
  CompletableFuture<Void> delete(String name);

  /** The full names of all parameters. */
  CompletableFuture<List<String>> names();
}
