package org.urbi.kernel;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/** What other languages call what urbiscript has. */
final class ForeignNames {
  private static final Map<String, String> ANYWHERE =
      Map.ofEntries(
          Map.entry("printf", "echo(\"… %s\" % [value])"),
          Map.entry("println", "echo(value)"),
          Map.entry("puts", "echo(value)"),
          Map.entry("console", "echo(value)"),
          Map.entry("cout", "echo(value)"),
          Map.entry("pop", "list.removeBack"),
          Map.entry("pow", "base ** exponent"),
          Map.entry("None", "nil"),
          Map.entry("NULL", "nil"),
          Map.entry("undefined", "nil"),
          Map.entry("True", "true"),
          Map.entry("False", "false"),
          Map.entry("len", "list.size"),
          Map.entry("length", "size"),
          Map.entry("strlen", "text.size"),
          Map.entry("append", "list << value"),
          Map.entry("push", "list << value"),
          Map.entry("push_back", "list << value"),
          Map.entry("str", "asString"),
          Map.entry("toString", "asString"),
          Map.entry("to_s", "asString"),
          Map.entry("parseInt", "asFloat"),
          Map.entry("parseFloat", "asFloat"),
          Map.entry("tonumber", "asFloat"),
          Map.entry("asInt", "asFloat"),
          Map.entry("toInt", "asFloat"),
          Map.entry("asInteger", "asFloat"),
          Map.entry("require", "load(\"file.u\")"),
          Map.entry("include", "load(\"file.u\")"),
          Map.entry("wait", "sleep(1s)"),
          Map.entry("setTimeout", "{ sleep(1s)| … },"),
          Map.entry("setInterval", "every (1s) …,"),
          Map.entry("Thread", "{ … }, beside what follows"),
          Map.entry("threading", "{ … }, beside what follows"),
          Map.entry("exit", "quit, shutdown"),
          Map.entry("isinstance", "value.isA(Float)"),
          Map.entry("super", "A.getSlot(\"init\").apply([this])"),
          Map.entry("Error", "Exception.new(\"…\")"),
          Map.entry("rospy", "loadModule(\"urbi/ros\")"),
          Map.entry("rclpy", "loadModule(\"urbi/ros\")"),
          Map.entry("pass", "{}"),
          Map.entry("math", "Math"),
          Map.entry("PI", "pi"),
          Map.entry("range", "for (var i : 3), 3.seq"));

  /** What is called so of these types only: elsewhere it may be anything. */
  private static final Map<String, Map<String, String>> BY_TYPE =
      Map.of(
          "String",
          Map.ofEntries(
              Map.entry("upper", "toUpper"),
              Map.entry("toUpperCase", "toUpper"),
              Map.entry("lower", "toLower"),
              Map.entry("toLowerCase", "toLower"),
              Map.entry("replaceAll", "replace"),
              Map.entry("substring", "text[0, 2]"),
              Map.entry("substr", "text[0, 2]"),
              Map.entry("sub", "text[0, 2]"),
              Map.entry("startswith", "text[0, 2] == \"ab\""),
              Map.entry("startsWith", "text[0, 2] == \"ab\""),
              Map.entry("strip", "text.split.join(\" \")"),
              Map.entry("trim", "text.split.join(\" \")"),
              Map.entry("find", "Regexp.new(\"b\").match(text)"),
              Map.entry("contains", "Regexp.new(\"b\").match(text)"),
              Map.entry("includes", "Regexp.new(\"b\").match(text)")),
          "List",
          Map.of(
              "add", "list << value",
              "contains", "value in list",
              "includes", "value in list",
              "forEach", "each",
              "reduce", "foldl",
              "sorted", "sort",
              "get", "list[index]",
              "first", "list.front",
              "last", "list.back"),
          "Dictionary",
          Map.of(
              "contains", "key in dictionary",
              "containsKey", "key in dictionary",
              "has_key", "key in dictionary",
              "items", "asList",
              "pop", "erase",
              "remove", "erase"),
          "Event",
          Map.of(
              "on", "at (event?) …",
              "addListener", "at (event?) …",
              "connect", "at (event?) …",
              "fire", "event!(value)",
              "raise", "event!(value)",
              "notify", "event!(value)",
              "send", "event!(value)"),
          "Tag",
          Map.ofEntries(
              Map.entry("kill", "tag.stop"),
              Map.entry("cancel", "tag.stop"),
              Map.entry("end", "tag.stop"),
              Map.entry("pause", "tag.freeze"),
              Map.entry("suspend", "tag.freeze"),
              Map.entry("resume", "tag.unfreeze"),
              Map.entry("start", "tag: { … }"),
              Map.entry("begin", "tag: { … }"),
              Map.entry("run", "tag: { … }")),
          "Float",
          Map.of("asInt", "trunc", "toInt", "trunc", "asInteger", "trunc"),
          "System",
          Map.of("out", "echo(value)"),
          "Math",
          Map.of("floor", "number.floor", "ceil", "number.ceil"));

  private ForeignNames() {}

  /** What urbiscript has instead of what is called so elsewhere, whatever was asked, or null. */
  static @Nullable String meant(String name) {
    return ANYWHERE.get(name);
  }

  /** What a type has instead of what is called so elsewhere, or null. */
  static @Nullable String meant(String name, String type) {
    return BY_TYPE.getOrDefault(type, Map.of()).get(name);
  }
}
