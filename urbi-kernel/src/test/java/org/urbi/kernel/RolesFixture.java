package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.AfterEach;
import org.urbi.kernel.trust.Role;

/** A kernel in simulated time with an owner, a user and an observer. */
abstract class RolesFixture {
  static final String NEEDS_OWNER = "needs the role owner, and this lobby has the role ";
  static final String NEEDS_USER = "needs the role user, and this lobby has the role ";

  Kernel kernel;
  TestClient owner;
  TestClient user;
  TestClient observer;

  /** Starts it; the program is the owner's, and says nothing. */
  final void start(KernelBuilder builder, String program) {
    kernel = builder.virtualTime(true).log(line -> {}).start();
    owner = new TestClient(kernel, Role.OWNER);
    user = new TestClient(kernel, Role.USER);
    observer = new TestClient(kernel, Role.OBSERVER);
    assertEquals("", owner.say(program));
  }

  @AfterEach
  final void close() {
    kernel.close();
  }

  static void assertRefused(TestClient visitor, String code, String text) {
    String answer = visitor.say(code);
    assertTrue(answer.contains("!!! ") && answer.contains(text), code + " -> " + answer);
  }
}
