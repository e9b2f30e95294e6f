package org.urbi.builtins;

import static java.util.stream.Collectors.joining;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/** Writes the Java source of a table, and of the list of all tables. */
final class TableWriter {
  /** How many builtins one method dispatches to: more would be too large for the JIT. */
  static final int CASES = 40;

  private final StringBuilder out = new StringBuilder();

  private TableWriter() {}

  /** The source of the table of one class. */
  static String table(Declaration type) {
    TableWriter writer = new TableWriter();
    writer.writeTable(type);
    return writer.out.toString();
  }

  /** The source of the list of all tables, in the order given. */
  static String index(List<Declaration> types) {
    TableWriter writer = new TableWriter();
    writer.writeIndex(types);
    return writer.out.toString();
  }

  private void line(String text) {
    out.append(text).append('\n');
  }

  private void writeTable(Declaration type) {
    String name = type.tableName();
    line("package " + type.packageName + ";");
    line("");
    line("/** The builtins of " + type.type + "; generated from " + type.className + ". */");
    line("public final class " + name + " extends " + KernelClassNames.TABLE + " {");
    List<String> entries = new ArrayList<>();
    List<String> labels = new ArrayList<>();
    int index = 0;
    for (Declaration.Method method : type.methods) {
      StringBuilder label = new StringBuilder("case ");
      for (int i = 0; i < method.names().size(); i++) {
        entries.add(entry(method.names().get(i), method));
        label.append(i == 0 ? "" : ", ").append(index++);
      }
      labels.add(label.append(":").toString());
    }
    // Every kernel makes a table; they share what was declared.
    line("  private static final Entry[] ENTRIES = {" + String.join(",", entries));
    line("  };");
    line("");
    if (isMade(type)) {
      line("  private final " + type.className + " builtins;");
      line("");
    }
    line("  public " + name + "(" + join(type.services) + ") {");
    line("    super(");
    line("        " + literal(type.type) + ",");
    line("        " + literal(type.doc) + ",");
    line("        " + strings(type.protos) + ",");
    line("        ENTRIES);");
    if (isMade(type)) {
      line("    this.builtins = new " + type.className + "(" + names(type.services) + ");");
    }
    line("  }");
    if (type.prototype != Declaration.Prototype.PLAIN_OBJECT) {
      boolean byClass = type.prototype == Declaration.Prototype.BY_CLASS;
      line("");
      line("  @Override");
      line(
          "  public "
              + KernelClassNames.OBJECT
              + " newPrototype("
              + KernelClassNames.WORLD
              + " world) {");
      line("    return " + (byClass ? type.className : "builtins") + ".newPrototype(world);");
      line("  }");
    }
    writeCalls(type, labels);
    line("}");
  }

  private static String entry(String name, Declaration.Method method) {
    return String.format(
        "%n    new Entry(%s, %d, %s, %b, %b, %s.%s, %b, %s, %s, %s)",
        literal(name),
        method.min(),
        method.max() < 0 ? "Integer.MAX_VALUE" : String.valueOf(method.max()),
        method.lazy(),
        method.setter(),
        KernelClassNames.ROLE,
        method.needs().role,
        method.needs().changes,
        literal(method.formals()),
        literal(method.resultType()),
        literal(method.doc()));
  }

  private static final String FORMALS =
      String.format(
          "(%n      int index,%n      %s caller,%n      %s site,%n      %s self,%n"
              + "      %s[] arguments) {",
          KernelClassNames.FRAME,
          KernelClassNames.CALL_SITE,
          KernelClassNames.OBJECT,
          KernelClassNames.OBJECT);

  private static final String ACTUALS = "(index, caller, site, self, arguments)";

  private void writeCalls(Declaration type, List<String> labels) {
    line("");
    line("  @Override");
    line("  public " + KernelClassNames.OBJECT + " call" + FORMALS);
    int parts = (type.methods.size() + CASES - 1) / CASES;
    int bound = 0;
    for (int part = 0; part < parts - 1; part++) {
      for (Declaration.Method m : chunk(type.methods, part)) {
        bound += m.names().size();
      }
      line("    if (index < " + bound + ") {");
      line("      return call" + part + ACTUALS + ";");
      line("    }");
    }
    line(
        parts == 0
            ? "    throw new IndexOutOfBoundsException(index);"
            : "    return call" + (parts - 1) + ACTUALS + ";");
    line("  }");
    for (int part = 0; part < parts; part++) {
      line("");
      String modifiers = isMade(type) ? "private " : "private static ";
      line("  " + modifiers + KernelClassNames.OBJECT + " call" + part + FORMALS);
      line("    switch (index) {");
      List<Declaration.Method> methods = chunk(type.methods, part);
      List<String> itsLabels = chunk(labels, part);
      for (int i = 0; i < methods.size(); i++) {
        line("      " + itsLabels.get(i));
        writeCase(type, methods.get(i));
      }
      line("      default:");
      line("        throw new IndexOutOfBoundsException(index);");
      line("    }");
      line("  }");
    }
  }

  /** Whether the builtins need an instance of the class. */
  private static boolean isMade(Declaration type) {
    return !type.services.isEmpty();
  }

  private static String join(Collection<Declaration.Service> services) {
    return services.stream().map(Declaration.Service::toString).collect(joining(", "));
  }

  private static String names(Collection<Declaration.Service> services) {
    return services.stream().map(Declaration.Service::name).collect(joining(", "));
  }

  private static <T> List<T> chunk(List<T> all, int part) {
    return all.subList(part * CASES, Math.min(all.size(), (part + 1) * CASES));
  }

  private void writeCase(Declaration type, Declaration.Method method) {
    List<String> actuals = new ArrayList<>();
    if (method.frame()) {
      actuals.add("caller");
    }
    if (method.site()) {
      actuals.add("site");
    }
    actuals.add(actual(method.self(), 0, "self"));
    for (int i = 0; i < method.arguments().size(); i++) {
      Declaration.Parameter p = method.arguments().get(i);
      String value = "arguments[" + i + "]";
      if (p.kind() == Declaration.Kind.REST) {
        actuals.add(KernelClassNames.ARGUMENTS + ".rest(arguments, " + i + ")");
      } else if (p.optional()) {
        actuals.add("arguments.length <= " + i + " ? null : " + actual(p, i + 1, value));
      } else {
        actuals.add(actual(p, i + 1, value));
      }
    }
    String call =
        (method.isStatic() ? type.className : "builtins")
            + "."
            + method.javaName()
            + "(\n            "
            + String.join(",\n            ", actuals)
            + ")";
    String values = "caller.interpreter().world().values()";
    switch (method.result()) {
      case VOID -> {
        line("        " + call + ";");
        line("        return " + values + ".voidObject;");
      }
      case OBJECT -> line("        return " + call + ";");
      case NUMBER -> line("        return " + values + ".number(" + call + ");");
      case BOOLEAN -> line("        return " + values + ".bool(" + call + ");");
      case STRING -> line("        return " + values + ".string(" + call + ");");
      case LIST -> line("        return " + values + ".list(" + call + ");");
    }
  }

  private static String actual(Declaration.Parameter p, int place, String value) {
    return switch (p.kind()) {
      case OBJECT -> value;
      case SUBCLASS ->
          String.format(
              "%s instanceof %s a%d ? a%d : %s.<%s>unexpected(caller, site, %d, %s, %s)",
              value,
              p.javaType(),
              place,
              place,
              KernelClassNames.ARGUMENTS,
              p.javaType(),
              place,
              value,
              literal(p.typeName()));
      default ->
          String.format(
              "%s.%s(caller, site, %d, %s)",
              KernelClassNames.ARGUMENTS, p.kind().unwrapper, place, value);
    };
  }

  private void writeIndex(List<Declaration> types) {
    Set<Declaration.Service> services =
        new TreeSet<>(
            Comparator.comparing(Declaration.Service::name)
                .thenComparing(Declaration.Service::javaType));
    types.forEach(type -> services.addAll(type.services));
    line("package " + KernelClassNames.INDEX_PACKAGE + ";");
    line("");
    line("/** The tables of all types of the library, in alphabetical order; generated. */");
    line("public final class " + KernelClassNames.INDEX_NAME + " {");
    line("  private " + KernelClassNames.INDEX_NAME + "() {}");
    line("");
    line("  /**");
    line(
        "   * New tables of all types; the parts of a type follow the class that declares it. What");
    line("   * the builtins need of the kernel is handed to those that need it.");
    line("   */");
    line("  public static " + KernelClassNames.TABLE + "[] all(" + join(services) + ") {");
    line("    return new " + KernelClassNames.TABLE + "[] {");
    for (Declaration type : types) {
      String needed = names(type.services);
      line("      new " + type.packageName + "." + type.tableName() + "(" + needed + "),");
    }
    line("    };");
    line("  }");
    line("");
    line(
        "  /** Tables that tell what is declared; what needs the kernel cannot be called in them. */");
    line("  @org.jspecify.annotations.NullUnmarked");
    line("  public static " + KernelClassNames.TABLE + "[] declarations() {");
    line("    return all(" + services.stream().map(s -> "null").collect(joining(", ")) + ");");
    line("  }");
    line("}");
  }

  private static String strings(@Nullable List<String> values) {
    if (values == null) {
      return "null";
    }
    return "new String[] {"
        + String.join(", ", values.stream().map(TableWriter::literal).toList())
        + "}";
  }

  private static String literal(String text) {
    StringBuilder quoted = new StringBuilder("\"");
    for (char c : text.toCharArray()) {
      switch (c) {
        case '"' -> quoted.append("\\\"");
        case '\\' -> quoted.append("\\\\");
        case '\n' -> quoted.append("\\n");
        default -> quoted.append(c < 32 || c > 126 ? String.format("\\u%04x", (int) c) : c);
      }
    }
    return quoted.append('"').toString();
  }
}
