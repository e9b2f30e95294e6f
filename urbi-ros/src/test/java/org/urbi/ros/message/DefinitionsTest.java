package org.urbi.ros.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.ros.Oracle;

class DefinitionsTest {
  private static final TypeName NAME = TypeName.message("my_msgs", "Mine");

  @TempDir Path folder;

  private static MessageDefinition read(Dialect dialect, String text) {
    return DefinitionReader.read(NAME, dialect, text);
  }

  private static String problem(Dialect dialect, String text) {
    return assertThrows(DefinitionException.class, () -> read(dialect, text)).getMessage();
  }

  private void write(String file, String text) throws IOException {
    Path path = folder.resolve(file);
    Files.createDirectories(path.getParent());
    Files.writeString(path, text);
  }

  private Definitions own(Dialect dialect) {
    return new Definitions(dialect, new InterfaceFiles(List.of(folder)));
  }

  @Test
  void constantsOfRosOneKeepWhatLooksLikeAComment() {
    MessageDefinition read =
        read(Dialect.ROS_1, "string A= # \"no\" comment \nint8 B = -1 # one\nbool C=True\n");
    assertEquals("# \"no\" comment", read.constants().get(0).value().stringValue());
    assertEquals(-1, read.constants().get(1).value().doubleValue());
    assertEquals(1, read.constants().get(2).value().doubleValue());
  }

  @Test
  void defaultsOfRosTwo() {
    MessageType strings = Oracle.definitions(Dialect.ROS_2).message("test_msgs/Strings");
    assertEquals(
        "Hello\"world!", Templates.of(strings).get("bounded_string_value_default5").stringValue());
    MessageType sequences = Oracle.definitions(Dialect.ROS_2).message("test_msgs/BoundedSequences");
    assertEquals(
        "[\"\", \"max value\", \"min value\"]",
        Templates.of(sequences).get("string_values_default").toString());
    assertEquals(3, Templates.of(sequences).get("byte_values_default").ubinaryValue().getSize());
  }

  @Test
  void templates() {
    assertEquals(
        "[\"header\" => [\"seq\" => 0, \"stamp\" => [\"sec\" => 0, \"nanosec\" => 0],"
            + " \"frame_id\" => \"\"], \"point\" => [\"x\" => 0, \"y\" => 0, \"z\" => 0]]",
        Templates.of(Oracle.definitions(Dialect.ROS_1).message("geometry_msgs/PointStamped"))
            .toString());
    assertEquals(
        36,
        Templates.of(Oracle.definitions(Dialect.ROS_2).message("geometry_msgs/PoseWithCovariance"))
            .get("covariance")
            .ulistValue()
            .size());
  }

  @Test
  void whatIsWrongIsSaidWithItsLine() {
    assertEquals(
        "my_msgs/Mine, line 2: a type and a name expected, not 'float64'",
        problem(Dialect.ROS_1, "# text\nfloat64"));
    assertTrue(problem(Dialect.ROS_1, "int32 a\nint32 a").contains("'a' already"));
    assertTrue(problem(Dialect.ROS_1, "string<=5 a").contains("no type"));
    assertTrue(problem(Dialect.ROS_1, "int32 a 5").contains("what is '5'"));
    assertTrue(problem(Dialect.ROS_2, "int8 A=200").contains("no int8"));
    assertTrue(problem(Dialect.ROS_2, "int8 A=").contains("no int8"));
    assertTrue(
        problem(Dialect.ROS_2, "uint64 A=" + "9".repeat(1_000_000)).contains("1000 characters"));
    assertTrue(problem(Dialect.ROS_2, "int8[2] a [1]").contains("2 elements"));
    assertTrue(problem(Dialect.ROS_2, "string<=2 a 'abc'").contains("2 bytes at most"));
    assertTrue(problem(Dialect.ROS_2, "int8[<=] a").contains("how many"));
    assertTrue(problem(Dialect.ROS_2, "a/b/c/d e").contains("name of a type"));
  }

  @Test
  void aTypeThatIsNotThereSaysWhereWasLooked() {
    String message =
        assertThrows(DefinitionException.class, () -> own(Dialect.ROS_1).message("std_msgs/Strin"))
            .getMessage();
    assertTrue(message.contains("std_msgs/Strin:"), message);
    assertTrue(message.contains(folder.toString()), message);
  }

  @Test
  void filesOfTheUserComeFirstAndAreReadAgain() throws IOException {
    write("std_msgs/msg/String.msg", "string text");
    assertEquals("[\"text\" => \"\"]", template("std_msgs/String"));
    write("std_msgs/msg/String.msg", "string other");
    assertEquals("[\"other\" => \"\"]", template("std_msgs/String"));
    assertEquals("[\"data\" => 0]", template("std_msgs/Bool"));
  }

  private String template(String type) {
    return Templates.of(own(Dialect.ROS_1).message(type)).toString();
  }

  @Test
  void packagesAreFoundBelowAFolderOfSources() throws IOException {
    write("src/group/my_msgs/msg/Mine.msg", "Header header\nOther[2] others\n");
    write("src/group/my_msgs/msg/Other.msg", "time when");
    write("src/group/my_msgs/package.xml", "");
    assertEquals(
        2,
        Templates.of(own(Dialect.ROS_1).message("my_msgs/Mine")).get("others").ulistValue().size());
  }

  @Test
  void whatContainsItselfIsRefused() throws IOException {
    write("my_msgs/msg/A.msg", "B[] b");
    write("my_msgs/msg/B.msg", "A a");
    assertThrows(DefinitionException.class, () -> own(Dialect.ROS_1).message("my_msgs/A"));
    write("my_msgs/msg/C.msg", "C c");
    assertThrows(DefinitionException.class, () -> own(Dialect.ROS_1).message("my_msgs/C"));
  }

  @Test
  void whatWouldFillTheMemoryIsRefused() throws IOException {
    write("my_msgs/msg/A.msg", "B[100000] b");
    write("my_msgs/msg/B.msg", "float64[100000] c");
    assertThrows(DefinitionException.class, () -> own(Dialect.ROS_1).message("my_msgs/A"));
  }

  @Test
  void foldersThatTheEnvironmentNames() throws IOException {
    write("share/my_msgs/srv/Ask.srv", "int8 a\n---\nint8 b\n");
    Definitions two =
        new Definitions(
            Dialect.ROS_2,
            InterfaceFiles.of(Dialect.ROS_2, Map.of("AMENT_PREFIX_PATH", "/nowhere:" + folder)));
    assertEquals("[\"b\" => 0]", Templates.of(two.service("my_msgs/Ask").response()).toString());
  }

  @Test
  void aTextWithAllThatIsInIt() {
    MessageType image = Oracle.definitions(Dialect.ROS_1).message("nav_msgs/Odometry");
    MessageType read = FullText.read(image.name(), FullText.write(image));
    assertEquals(TypeHash.md5(image), TypeHash.md5(read));
    assertThrows(DefinitionException.class, () -> FullText.read(NAME, "std_msgs/Header header\n"));
  }
}
