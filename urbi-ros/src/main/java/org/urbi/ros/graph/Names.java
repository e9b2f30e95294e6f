package org.urbi.ros.graph;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * How the names of topics, services and parameters are understood: {@code /full}, {@code relative}
 * to the namespace, {@code ~private} of the node; and then remapped.
 *
 * @param node the full name of the node
 * @param namespace where relative names are: {@code /} or {@code /robot}
 * @param remappings full names, and what is meant by them
 */
public record Names(String node, String namespace, Map<String, String> remappings) {
  private static final Pattern FORM = Pattern.compile("(~/?|/)?[a-zA-Z][\\w/]*");

  /**
   * The names of a node.
   *
   * @param name a relative or full name
   * @param remappings names as a user writes them
   * @throws RosException if one is no name
   */
  public static Names of(String name, String namespace, Map<String, String> remappings) {
    String space = clean("/" + namespace);
    Names plain = new Names("/", space, Map.of());
    String node = plain.resolve(name);
    Names own = new Names(node, space, Map.of());
    Map<String, String> resolved = new LinkedHashMap<>();
    remappings.forEach((from, to) -> resolved.put(own.resolve(from), own.resolve(to)));
    return new Names(node, space, Map.copyOf(resolved));
  }

  /**
   * The full name that is meant.
   *
   * @throws RosException if it is no name
   */
  public String resolve(String name) {
    if (name.isEmpty() || !FORM.matcher(name).matches() || clean(name).equals("/")) {
      throw new RosException(
          "invalid name '" + name + "': letters, digits, '/' and '_' expected, no digit first");
    }
    String full =
        switch (name.charAt(0)) {
          case '/' -> name;
          case '~' -> node + "/" + name.substring(1);
          default -> namespace + "/" + name;
        };
    String clean = clean(full);
    return remappings.getOrDefault(clean, clean);
  }

  private static String clean(String name) {
    String once = name.replaceAll("/+", "/");
    return once.length() > 1 && once.endsWith("/") ? once.substring(0, once.length() - 1) : once;
  }
}
