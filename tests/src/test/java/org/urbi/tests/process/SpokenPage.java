package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.urbi.server.studio.messages.BadMessage;
import org.urbi.server.studio.messages.Json;

/**
 * A page as screen readers are told of it: the accessibility tree that Chromium makes, whatever the
 * page itself says of its elements.
 */
final class SpokenPage {
  /** What says nothing of how something can be used. */
  private static final Set<String> NOTHING = Set.of("", "none", "generic", "presentation");

  private SpokenPage() {}

  /** Whatever keys come to says what it is, and how it is called. */
  static void check(Browser browser, String what) throws IOException, BadMessage {
    List<String> faults = new ArrayList<>();
    int reached = 0;
    for (Object each : nodes(browser)) {
      Map<?, ?> node = (Map<?, ?>) each;
      if (isFocusable(node)) {
        reached++;
        String role = value(node, "role");
        String name = value(node, "name").strip();
        if (NOTHING.contains(role) || name.isEmpty()) {
          faults.add("role \"" + role + "\", name \"" + name + "\"");
        }
      }
    }
    assertEquals(List.of(), faults, what);
    assertEquals(true, reached > 5, what + ": only " + reached + " controls");
  }

  private static List<?> nodes(Browser browser) throws IOException, BadMessage {
    String answer = browser.accessibilityTree();
    Map<?, ?> result = (Map<?, ?>) Json.read(answer.getBytes(StandardCharsets.UTF_8)).get("value");
    return (List<?>) result.get("nodes");
  }

  private static boolean isFocusable(Map<?, ?> node) {
    if (Boolean.TRUE.equals(node.get("ignored"))
        || !(node.get("properties") instanceof List<?> properties)) {
      return false;
    }
    return properties.stream()
        .map(each -> (Map<?, ?>) each)
        .anyMatch(
            each -> "focusable".equals(each.get("name")) && "true".equals(value(each, "value")));
  }

  /** What is behind a name: it is an object with its value. */
  private static String value(Map<?, ?> of, String name) {
    return of.get(name) instanceof Map<?, ?> map ? String.valueOf(map.get("value")) : "";
  }
}
