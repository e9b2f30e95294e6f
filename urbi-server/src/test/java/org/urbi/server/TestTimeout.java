package org.urbi.server;

import java.time.Duration;

/**
 * How long tests wait for what must come. It says nothing about speed: on a machine that has much
 * else to do everything takes long. The project's pom sets it, with the limit of whole tests.
 */
public final class TestTimeout {
  /** Less than the limit of a test, so that it can say what it has waited for. */
  public static final Duration LONG = Duration.ofSeconds(Integer.getInteger("test.limit", 600) / 2);

  private TestTimeout() {}
}
