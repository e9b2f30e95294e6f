/** Where statements and lines are in a text, before it is parsed. */
package org.urbi.lang.text;
