package org.urbi.web;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

/** By which names a page is served, as browsers say them. */
class HostNamesTest {
  private static final List<String> OF_THIS_MACHINE =
      List.of("localhost", "LOCALHOST:54080", "127.0.0.1:54080", "127.1.2.3", "[::1]:54080");

  private static final List<String> OF_NOBODY_ELSE =
      List.of(
          "192.168.1.7",
          "192.168.1.7:54080",
          "[fe80::1:2]:54080",
          "robot",
          "robot:54080",
          "Robot.local:54080",
          "arm.robot.internal",
          "robot.home.arpa");

  private static final List<String> OF_ANYBODY =
      List.of(
          "robot.example.org",
          "robot.example.org:54080",
          "127.0.0.1.example.org",
          "local.example.org",
          "robotlocal.org",
          "localhost.example",
          "",
          "robot.local@example.org",
          "example.org:robot.local");

  private static void check(HostNames names, List<String> hosts, boolean allowed) {
    for (String host : hosts) {
      assertEquals(allowed, names.allow(host), host);
    }
  }

  @Test
  void pageOfThisMachineHasItsNamesAlone() {
    HostNames names = new HostNames(true, "127.0.0.1", true);
    check(names, OF_THIS_MACHINE, true);
    check(names, OF_NOBODY_ELSE, false);
    check(names, OF_ANYBODY, false);
  }

  /** A name of another site could lead here, and its page command without a token. */
  @Test
  void pageWithoutTokensHasNoNameOfAnotherSite() {
    HostNames names = new HostNames(false, "0.0.0.0", true);
    check(names, OF_THIS_MACHINE, true);
    check(names, OF_NOBODY_ELSE, true);
    check(names, OF_ANYBODY, false);
  }

  @Test
  void nameThatWasGivenIsTaken() {
    HostNames names = new HostNames(false, "robot.example.org", true);
    check(names, List.of("robot.example.org", "ROBOT.example.org:54080"), true);
    check(names, List.of("robotxexample.org", "other.example.org"), false);
  }

  @Test
  void pageWithTokensHasAnyName() {
    check(new HostNames(false, "0.0.0.0", false), OF_ANYBODY, true);
  }
}
