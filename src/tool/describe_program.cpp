// Copyright (c) 2026 The Extremal_mesh_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "describe_program.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cctype>

namespace CGAL::Extremal_mesh_3::tool {

namespace {

/// a text as roff has it.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n'))
      result += std::string("\\&") + c;
    else
      result += c;
  }
  return result;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

/// those that --help shows.
std::vector<const CLI::Option*> options_of(const CLI::App& app, bool positional) {
  return app.get_options([&](const CLI::Option* option) {
    return option->get_positional() == positional && !option->get_group().empty();
  });
}

/// "-o, --output"
std::string names_of(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames())
    names += (names.empty() ? "-" : ", -") + name;
  for (const std::string& name : option.get_lnames())
    names += (names.empty() ? "--" : ", --") + name;
  return names;
}

std::string options_in_roff(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : options_of(app, true))
    text += fmt::format(".TP\n.I {}\n{}\n", roff(option->get_name(true)), roff(option->get_description()));
  for (const CLI::Option* option : options_of(app, false)) {
    const std::string type = option->get_type_name();
    text += fmt::format(".TP\n.B {}{}\n{}\n", roff(names_of(*option)),
                        option->get_expected_min() == 0 || type.empty() ? "" : fmt::format(" \\fI{}\\fR", roff(type)),
                        roff(option->get_description()));
  }
  return text;
}

/// the footer of a command: its examples, as they are.
std::string footer_in_roff(const CLI::App& app) {
  return app.get_footer().empty() ? "" : fmt::format(".PP\n.nf\n{}\n.fi\n", roff(app.get_footer()));
}

/// the values of an option whose type is named like "sign|cell": empty if it takes anything else.
std::string values_of(const CLI::Option& option) {
  std::string values = option.get_type_name();
  if (values.find('|') == values.npos)
    return "";
  for (char& c : values) {
    if (std::isupper(static_cast<unsigned char>(c)) != 0)
      return "";
    c = c == '|' ? ' ' : c;
  }
  return values;
}

std::string words_of(const CLI::App& app) {
  std::string words;
  for (const CLI::Option* option : options_of(app, false)) {
    for (const std::string& name : option->get_lnames())
      words += (words.empty() ? "--" : " --") + name;
    for (const std::string& name : option->get_snames())
      words += (words.empty() ? "-" : " -") + name;
  }
  return words;
}

} // namespace

std::string man_page(const CLI::App& app) {
  std::string text = fmt::format(".TH EXTREMAL_MESH 1 \"\" \"{}\" \"User Commands\"\n.SH NAME\nextremal_mesh \\- {}\n"
                                 ".SH SYNOPSIS\n.B extremal_mesh\n.I COMMAND\n[\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n",
                                 roff("extremal_mesh " EXTREMAL_MESH_3_VERSION), roff("the extremal mesh of surfaces"));
  text += "The extremal mesh of a surface consists of the lines where a principal curvature is extremal along its own "
          "line of\n"
          "curvature, among them the crest lines, of the points where they cross, of the umbilics, and of the cells "
          "between\n"
          "them. This program extracts it from a formula, a 3D image or a polygon mesh, and works with the result.\n";
  text += ".SH COMMANDS\n";
  for (const CLI::App* command : commands_of(app))
    text += fmt::format(".SS {}\n{}\n{}{}", roff(command->get_name()), roff(command->get_description()),
                        options_in_roff(*command), footer_in_roff(*command));
  text += ".SH OPTIONS\n" + options_in_roff(app);
  text +=
      ".SH EXIT STATUS\n.TP\n.B 0\ndone; check: all identities hold\n.TP\n.B 1\nfailed, or an identity is violated; "
      "register: no motion was found\n.TP\n.B 2\nthe command line makes no sense\n.TP\n.B 130\ninterrupted; no file is "
      "left half written\n";
  return text;
}

std::string bash_completion(const CLI::App& app) {
  std::string commands, words, values;
  for (const CLI::App* command : commands_of(app)) {
    commands += (commands.empty() ? "" : " ") + command->get_name();
    words += fmt::format("    {}) words='{}' ;;\n", command->get_name(), words_of(*command));
    for (const CLI::Option* option : options_of(*command, false))
      if (const std::string of_option = values_of(*option); !of_option.empty())
        for (const std::string& name : option->get_lnames())
          values += fmt::format("    '{} --{}') words='{}' values=yes ;;\n", command->get_name(), name, of_option);
  }
  return fmt::format(R"(# bash completion of extremal_mesh, made by the program itself
_extremal_mesh() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} words='' values=''
  COMPREPLY=()
  if [[ $COMP_CWORD -eq 1 ]]; then
    mapfile -t COMPREPLY < <(compgen -W '{} {}' -- "$current")
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD-1]}}" in
{}  esac
  if [[ $current == -* || -n $values ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  fi
}}
complete -o default -F _extremal_mesh extremal_mesh
)",
                     commands, words_of(app), words, values);
}

} // namespace CGAL::Extremal_mesh_3::tool
