package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.tests.KernelSession.BackEnd;
import org.urbi.tests.KernelSession.Console;

/** Several sessions with one kernel (manual, "Getting Started"). */
class SessionTest {

  @ParameterizedTest
  @EnumSource
  void quitEndsItsOwnSessionOnly(BackEnd backEnd) throws Exception {
    try (KernelSession session = KernelSession.inVirtualTime(backEnd)) {
      Console first = session.connect();
      Console second = session.connect();
      first.send("quit;\n");
      first.whenClosed().get();
      second.send("20+3;\n");
      second.receives("] 23\n").get();
      assertFalse(second.whenClosed().isDone());
    }
  }

  @ParameterizedTest
  @EnumSource
  void shutdownEndsTheKernel(BackEnd backEnd) throws Exception {
    try (KernelSession session = KernelSession.inVirtualTime(backEnd)) {
      Console console = session.connect();
      console.send("echo(\"bye\");\nshutdown;\n");
      session.awaitShutdown();
      assertTrue(console.output().contains("*** bye"), console.output());
    }
  }

  @ParameterizedTest
  @EnumSource
  void anEndedConnectionClosesWhenItsJobsAreOver(BackEnd backEnd) throws Exception {
    try (KernelSession session = KernelSession.inVirtualTime(backEnd)) {
      Console console = session.connect();
      console.send("sleep(5s);\necho(\"after all\");\n");
      console.end();
      console.whenClosed().get();
      assertTrue(console.output().contains("[00005000] *** after all"), console.output());
    }
  }

  @ParameterizedTest
  @EnumSource
  void sessionsShareGlobalAndKeepTheirLobbies(BackEnd backEnd) throws Exception {
    try (KernelSession session = KernelSession.inVirtualTime(backEnd)) {
      Console first = session.connect();
      Console second = session.connect();
      first.send("var mine = 11;\nvar Global.ours = 12;\n");
      first.receives("] 12\n").get();
      second.send("mine;\nours;\n");
      second.receives("] 12\n").get();
      assertTrue(second.output().contains("lookup failed: mine"), second.output());
    }
  }

  @ParameterizedTest
  @EnumSource
  void aBusySessionDoesNotKeepAnotherWaiting(BackEnd backEnd) throws Exception {
    try (KernelSession session = KernelSession.inRealTime(backEnd)) {
      Console busy = session.connect();
      busy.send("loop {};\n");
      Console other = session.connect();
      other.send("20+3;\n");
      other.receives("] 23\n").get();
    }
  }
}
