package org.urbi.builtins;

import java.util.LinkedHashMap;
import java.util.Map;

/** The least kernel that tables can be compiled against. */
final class KernelStubs {
  private KernelStubs() {}

  /** The stubs, by the qualified names of their classes. */
  static Map<String, String> sources() {
    Map<String, String> sources = new LinkedHashMap<>();
    sources.put(
        "org.urbi.kernel.object.UrbiObject",
        "package org.urbi.kernel.object; public class UrbiObject {}");
    sources.put(
        "org.urbi.kernel.trust.Role",
        "package org.urbi.kernel.trust; public enum Role { OBSERVER, USER, OWNER }");
    sources.put(
        "org.urbi.kernel.object.UrbiFloat",
        """
        package org.urbi.kernel.object;
        public class UrbiFloat extends UrbiObject {
          public final double value;
          public UrbiFloat(double value) { this.value = value; }
        }
        """);
    sources.put(
        "org.urbi.kernel.object.World",
        """
        package org.urbi.kernel.object;
        public class World {
          public Values values() { return new Values(); }
          public static class Values {
            public final UrbiObject voidObject = null;
            public UrbiObject number(double d) { return new UrbiFloat(d); }
            public UrbiObject bool(boolean b) { return new UrbiFloat(b ? 1 : 0); }
            public UrbiObject string(String s) { return new UrbiFloat(s.length()); }
            public UrbiObject list(java.util.Collection<? extends UrbiObject> c) {
              return new UrbiFloat(c.size());
            }
          }
        }
        """);
    sources.put(
        "org.urbi.kernel.node.Frame",
        """
        package org.urbi.kernel.node;
        public class Frame {
          public Frame interpreter() { return this; }
          public org.urbi.kernel.object.World world() {
            return new org.urbi.kernel.object.World();
          }
        }
        """);
    sources.put(
        "org.urbi.kernel.node.CallSite",
        "package org.urbi.kernel.node; public interface CallSite {}");
    sources.put(
        "org.urbi.kernel.builtin.Arguments",
        """
        package org.urbi.kernel.builtin;
        import org.urbi.kernel.node.*;
        import org.urbi.kernel.object.*;
        public class Arguments {
          public static <T> T unexpected(
              Frame f, CallSite s, int place, UrbiObject given, String expected) {
            throw new IllegalArgumentException(place + " is not a " + expected);
          }
          public static double number(Frame f, CallSite s, int place, UrbiObject given) {
            return ((UrbiFloat) given).value;
          }
          public static int integer(Frame f, CallSite s, int place, UrbiObject given) {
            return (int) ((UrbiFloat) given).value;
          }
          public static UrbiObject[] rest(UrbiObject[] all, int from) {
            return java.util.Arrays.copyOfRange(all, Math.min(from, all.length), all.length);
          }
        }
        """);
    sources.put(
        "org.urbi.kernel.builtin.BuiltinTable",
        """
        package org.urbi.kernel.builtin;
        import org.urbi.kernel.node.*;
        import org.urbi.kernel.object.*;
        public abstract class BuiltinTable {
          public record Entry(
              String name, int min, int max, boolean lazy, boolean setter,
              org.urbi.kernel.trust.Role least, boolean changes, String formals, String result,
              String doc) {
            @Override public String toString() {
              return name + formals + ":" + result + " " + min + ".." + (max == Integer.MAX_VALUE ? "" : max);
            }
          }
          private final String type;
          private final Entry[] entries;
          protected BuiltinTable(String type, String doc, String[] protos, Entry[] entries) {
            this.type = type;
            this.entries = entries;
          }
          @Override public String toString() {
            return type + " " + java.util.Arrays.toString(entries);
          }
          public UrbiObject newPrototype(World world) { return null; }
          public abstract UrbiObject call(
              int index, Frame caller, CallSite site, UrbiObject self, UrbiObject[] arguments);
        }
        """);
    return sources;
  }
}
