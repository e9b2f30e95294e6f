package org.urbi.tests;

import java.time.Duration;

/**
 * How long tests wait for an event that must happen. It says nothing about speed: on a busy machine
 * everything takes long. The project's pom sets it, together with the limit of whole tests.
 */
public final class TestTimeout {
  /** Less than the limit of a test, so that the test can report what it waited for. */
  public static final Duration LONG = Duration.ofSeconds(Integer.getInteger("test.limit", 600) / 2);

  private TestTimeout() {}
}
