package org.urbi.kernel.trust;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import org.junit.jupiter.api.Test;

/** The names of roles: an option that is mistyped must not give more than was meant. */
class RoleTest {
  @Test
  void eachRoleHasAName() {
    for (Role each : Role.values()) {
      assertSame(each, Role.of(each.text()));
      assertEquals(each.text(), each.text().toLowerCase(Locale.ROOT));
    }
  }

  @Test
  void othersAreNoRoles() {
    for (String text : new String[] {"", "Owner", "OWNER", " owner", "owners", "admin"}) {
      assertNull(Role.of(text), text);
    }
  }

  @Test
  void rolesIncludeThoseBeforeThem() {
    assertTrue(Role.OBSERVER.compareTo(Role.USER) < 0);
    assertTrue(Role.USER.compareTo(Role.OWNER) < 0);
  }
}
