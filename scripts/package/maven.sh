# Sourced by scripts/packages: a repository of Maven in a folder, with the libraries, their sources and Javadoc, a bill of
# materials (urbi-bom) and the archetype of a component in Java.
say "making artifacts for Maven, this takes minutes…"
repository=$made/maven-repository
libraries=urbi-lang,urbi-builtins,uobject-java,urbi-kernel,uobject-native-bridge,urbi-web,urbi-server,sim-devices,urbi-ros
publish() { # OPTION…: into the repository
  run_maven -q "$@" "-DaltDeploymentRepository=packages::file://$repository" >"$made/work/maven.log" 2>&1 ||
    { grep '^\[ERROR\]' "$made/work/maven.log" | head -n 20 >&2; return 1; }
}
publish -Ppublish -pl "$libraries" -Dmaven.test.skip=true deploy

artifact() { # FOLDER: the beginning of a pom, with what the main one says of the project
  mkdir -p "$1"
  echo '<?xml version="1.0" encoding="UTF-8"?>
<project xmlns="http://maven.apache.org/POM/4.0.0">
  <modelVersion>4.0.0</modelVersion>'
  echo "  <parent><groupId>org.urbi</groupId><artifactId>urbi</artifactId><version>$version</version>
    <relativePath>$root/pom.xml</relativePath></parent>"
}
deploy_file=org.apache.maven.plugins:maven-deploy-plugin:3.1.4:deploy-file

# The main pom says where the project lives, for all of them. Maven publishes it as it is written, whatever -D says.
sed "s|<project.home>.*</project.home>|<project.home>$home</project.home>|" pom.xml >"$made/work/urbi.pom"
publish "$deploy_file" -Dfile="$made/work/urbi.pom" -DpomFile="$made/work/urbi.pom" -Durl="file://$repository" -DrepositoryId=packages

bom=$made/work/urbi-bom
{
  artifact "$bom" | sed '/relativePath/s/<relativePath>.*<.relativePath>/<relativePath\/>/'
  echo '  <artifactId>urbi-bom</artifactId>
  <packaging>pom</packaging>
  <name>Urbi: bill of materials</name>
  <description>The versions of all libraries of Urbi on the JVM, to be imported.</description>
  <dependencyManagement>
    <dependencies>'
  for library in ${libraries//,/ }; do
    echo "      <dependency><groupId>org.urbi</groupId><artifactId>$library</artifactId><version>$version</version></dependency>"
  done
  echo '    </dependencies>
  </dependencyManagement>
</project>'
} >"$bom.pom"
publish "$deploy_file" -Dfile="$bom.pom" -DpomFile="$bom.pom" -Durl="file://$repository" -DrepositoryId=packages

# The archetype is what `urbi new` makes, in the words of Maven's templates.
archetype=$made/work/urbi-component-archetype
templates=urbi-server/src/main/resources/org/urbi/server/make
mkdir -p "$archetype"/META-INF/maven "$archetype"/archetype-resources/src/{main/java,test/java,test/urbi}
template() { # TEMPLATE FILE
  # shellcheck disable=SC2016
  sed -e '1i #set($dollar = "$")' -e 's/\${/${dollar}{/g' -e 's/{{NAME}}/${artifactId}/g' -e 's/{{CLASS}}/${component}/g' \
    -e "s/{{VERSION}}/$version/g" -e 's/{{JAVA}}/25/g' -e 's/{{ROOT_XML}}/${urbiRoot}/g' \
    -e 's/^\(#\+\) /${hash}\1 /' "$templates/$1" | sed 's/\${hash}#/${hash}/; 1s/$/#set($hash = "#")/' \
    >"$archetype/archetype-resources/$2"
}
template java/pom.xml pom.xml
template java/README.md README.md
template java/Component.java src/main/java/__component__.java
template java/ComponentTest.java src/test/java/__component__Test.java
template test.u src/test/urbi/__artifactId__.u
cat >"$archetype/META-INF/maven/archetype-metadata.xml" <<'EOF'
<?xml version="1.0" encoding="UTF-8"?>
<archetype-descriptor xmlns="http://maven.apache.org/plugins/maven-archetype-plugin/archetype-descriptor/1.1.0" name="component">
  <requiredProperties>
    <requiredProperty key="component"><defaultValue>Thermometer</defaultValue></requiredProperty>
    <requiredProperty key="urbiRoot"><defaultValue>/usr/lib/urbi</defaultValue></requiredProperty>
  </requiredProperties>
  <fileSets>
    <fileSet filtered="true"><directory>src/main/java</directory><includes><include>**/*.java</include></includes></fileSet>
    <fileSet filtered="true"><directory>src/test/java</directory><includes><include>**/*.java</include></includes></fileSet>
    <fileSet filtered="true"><directory>src/test/urbi</directory><includes><include>**/*.u</include></includes></fileSet>
    <fileSet filtered="true"><directory></directory><includes><include>README.md</include></includes></fileSet>
  </fileSets>
</archetype-descriptor>
EOF
{
  artifact "$made/work" | sed '/relativePath/s/<relativePath>.*<.relativePath>/<relativePath\/>/'
  echo '  <artifactId>urbi-component-archetype</artifactId>
  <name>Urbi: archetype of a component</name>
  <description>The project of a component of urbiscript in Java.</description>
</project>'
} >"$archetype.pom"
"$jdk/bin/jar" --create --file "$archetype.jar" -C "$archetype" .
publish "$deploy_file" -Dfile="$archetype.jar" -DpomFile="$archetype.pom" -Durl="file://$repository" -DrepositoryId=packages
finished "$repository"
